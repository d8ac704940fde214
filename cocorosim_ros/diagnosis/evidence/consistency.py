"""Checks of velocity streams against the track: are their speeds of one size, and is the one over ground its rate?"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import SPEEDS
from cocorosim_ros.diagnosis.evidence.frames.agreement import both_given, correlation, independent
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion, motion_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import GROUND, VELOCITIES, WATER
from cocorosim_ros.scenario.parts.platform import Platform

_CAUSES = {
    WATER: "a current, or lengths or speeds are scaled wrongly",
    GROUND: "lengths or speeds are scaled wrongly, or it is the velocity through the water, which is called 'velocity'",
}


def speed_sentences(log: RobotLog, platform: Platform) -> Iterator[str]:
    """Sentences on velocity streams and poses whose speeds differ in size, or that drift against one another."""
    present = [topic for topic in VELOCITIES if topic in log.streams]
    if "pose" not in log.streams or not present:
        return
    motion = motion_of(log, platform)
    for topic in present:
        size = _of_another_size(log.name, topic, motion)
        if size:
            yield size
        elif topic == GROUND:
            yield from _drifting(log.name, motion)


def _of_another_size(name: str, topic: str, motion: ShownMotion) -> str:
    """A sentence if the speeds of a velocity stream and of the poses differ in size; empty if they agree."""
    moved, shown = motion.moved[topic], motion.course * np.exp(-1j * motion.yaw)
    given = both_given(shown, moved)
    if independent(shown, moved, motion.weight) < SPEEDS.fewest:
        return ""
    if correlation(shown, moved).real < SPEEDS.related:
        return ""
    ratio = float(np.sqrt(np.mean(np.abs(moved[given]) ** 2) / np.mean(np.abs(shown[given]) ** 2)))
    smallest, largest = SPEEDS.alike
    if smallest < ratio < largest:
        return ""
    return f"{name}/{topic}: its speeds are {ratio:.2f} times those of the poses: {_CAUSES[topic]}."


def _drifting(name: str, motion: ShownMotion) -> Iterator[str]:
    """A sentence if the velocity over ground differs from that of the poses by a drift, as one through the water does.

    In world axes their difference is then constant. Where a factor, turned or not, explains it as well, axes or a scale
    may be in error.
    """
    moved = motion.moved[GROUND] * np.exp(1j * motion.yaw)
    given = both_given(motion.course, moved)
    if independent(motion.course, moved, motion.weight) < SPEEDS.fewest:
        return
    course, moved = motion.course[given], moved[given]
    off = course - moved
    drift, factor = complex(off.mean()), complex(np.vdot(moved, off) / np.vdot(moved, moved))
    left, left_by_factor = (float(np.mean(np.abs(each) ** 2)) for each in (off - drift, off - factor * moved))
    pace = float(np.sqrt(np.mean(np.abs(course) ** 2)))
    if abs(drift) > SPEEDS.drift * pace and left < SPEEDS.constant * left_by_factor:
        yield (
            f"{name}/{GROUND}: the poses move by ({drift.real:.3g}, {drift.imag:.3g}) m/s in the world against it, at "
            "every heading, as if it were the velocity through the water in a current; if it is, call it 'velocity'."
        )
