"""Checks of velocity streams against the track: are their speeds of one size, and of the water or of the ground?"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import SPEEDS
from cocorosim_ros.diagnosis.evidence.frames.agreement import both_given, correlation, independent
from cocorosim_ros.diagnosis.evidence.frames.expected import Complex
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion, motion_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import OVER_GROUND, THROUGH_WATER, VELOCITIES
from cocorosim_ros.scenario.parts.platform import Platform

_CAUSES = {
    THROUGH_WATER: "a current, or lengths or speeds are scaled wrongly",
    OVER_GROUND: "lengths or speeds are scaled wrongly",
}


def speed_sentences(log: RobotLog, platform: Platform) -> Iterator[str]:
    """Sentences on velocity streams and poses whose speeds differ in size, or that drift as the other kind would."""
    present = [topic for topic in VELOCITIES if topic in log.streams]
    if "pose" not in log.streams or not present:
        return
    motion = motion_of(log, platform)
    for topic in present:
        kind = _of_the_water(log.name, motion) if topic == OVER_GROUND else _of_the_ground(log.name, motion)
        said = kind or _of_another_size(log.name, topic, motion)
        if said:
            yield said


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


def _of_the_water(name: str, motion: ShownMotion) -> str:
    """A sentence if poses drift against the velocity over ground, as against one through the water; else empty."""
    drift = _drift(motion, motion.moved[OVER_GROUND] * np.exp(1j * motion.yaw))
    if drift == 0.0:
        return ""
    return (
        f"{name}/{OVER_GROUND}: the poses move by {_in_text(drift)} against it, at every heading, as if it were the "
        f"velocity through the water in a current; if it is, call it '{THROUGH_WATER}'."
    )


def _of_the_ground(name: str, motion: ShownMotion) -> str:
    """A sentence if poses drift against the commands, but not against the velocity through the water; else empty."""
    drift = _drift(motion, motion.by_yaw.commanded, motion.by_yaw.led)
    against_it = motion.course - motion.moved[THROUGH_WATER] * np.exp(1j * motion.yaw)
    if drift == 0.0 or not np.isfinite(against_it).any():
        return ""
    if abs(np.mean(against_it[np.isfinite(against_it)])) > SPEEDS.unseen * abs(drift):
        return ""
    return (
        f"{name}/{THROUGH_WATER}: it has the drift of {_in_text(drift)} that the poses have at every heading beside "
        "what the commands let one expect; if that is a current, it is the velocity over ground: call it "
        f"'{OVER_GROUND}'."
    )


def _drift(motion: ShownMotion, *courses: Complex) -> complex:
    """Drift x + iy [m/s; world] of the poses beside courses (n,), each times a factor; 0 where it is not clear.

    Where the robot heads one way, a factor explains what a drift does; over several headings it cannot.
    """
    given = np.isfinite(motion.course + sum(courses))
    if np.count_nonzero(given) * motion.weight < SPEEDS.fewest:
        return 0.0
    if abs(np.mean(np.exp(1j * motion.yaw[given]))) > SPEEDS.one_heading:
        return 0.0
    course = motion.course[given]
    moved = np.column_stack([each[given] for each in courses])
    drifting = np.column_stack([np.ones(len(course)), moved])
    (drift, *_), left = _explained(course, drifting)
    pace = float(np.sqrt(np.mean(np.abs(course) ** 2)))
    clear = abs(drift) > SPEEDS.drift * pace and left < SPEEDS.explained * _explained(course, moved)[1]
    return complex(drift) if clear else 0.0


def _explained(course: Complex, parts: Complex) -> tuple[Complex, float]:
    """Factors (m,) of parts (n, m) that make a course (n,) up best, and the mean square that they leave of it."""
    factors = np.asarray(np.linalg.lstsq(parts, course, rcond=None)[0], dtype=np.complex128)
    return factors, float(np.mean(np.abs(course - parts @ factors) ** 2))


def _in_text(drift: complex) -> str:
    return f"({drift.real:.3g}, {drift.imag:.3g}) m/s in the world"
