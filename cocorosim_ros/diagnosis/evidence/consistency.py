"""A check of the velocity stream against the track: are their speeds of one size?"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import SPEEDS
from cocorosim_ros.diagnosis.evidence.frames.agreement import both_given, correlation, independent
from cocorosim_ros.diagnosis.evidence.frames.motion import motion_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.scenario.parts.platform import Platform


def speed_sentence(log: RobotLog, platform: Platform) -> str:
    """A sentence if the speeds of the velocity stream and of the poses differ in size; empty if they agree."""
    if not {"pose", "velocity"} <= log.streams.keys():
        return ""
    motion = motion_of(log, platform)
    shown = motion.course * np.exp(-1j * motion.yaw)
    given = both_given(shown, motion.through)
    if independent(shown, motion.through, motion.weight) < SPEEDS.fewest:
        return ""
    if correlation(shown, motion.through).real < SPEEDS.related:
        return ""
    ratio = float(np.sqrt(np.mean(np.abs(motion.through[given]) ** 2) / np.mean(np.abs(shown[given]) ** 2)))
    smallest, largest = SPEEDS.alike
    if smallest < ratio < largest:
        return ""
    return (
        f"{log.name}/velocity: its speeds are {ratio:.2f} times those of the poses: a current, or lengths or speeds "
        "are scaled wrongly."
    )
