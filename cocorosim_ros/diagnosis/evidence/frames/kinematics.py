"""Kinematics before physics: streams that are rates of one another, whatever moves the vehicle, and whether they are.

The rate of a heading, a gyroscope's rate and the rate of the poses' yaw are one number; so are the velocity of the
poses and a velocity stream turned into the world. That holds at every moment: readings are independent as their noise
is, however long a motion lasts. So slow vehicles show wrong columns too, of which axes and signs alone say nothing in
the few swings of a zigzag.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AGREEMENT, KINEMATICS, UNITS
from cocorosim_ros.diagnosis.evidence.frames.agreement import (
    Numbers,
    alignment,
    both_given,
    correlation,
    independent,
    slope,
)
from cocorosim_ros.diagnosis.evidence.frames.correction import CERTAIN, FrameCorrection
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion


def noise_weight(motion: ShownMotion) -> float:
    """Independent readings of noise by moment, at most one a second; `motion.weight` counts independent motions."""
    return min(1.0, motion.width / AGREEMENT.least_memory)


def contradictions(motion: ShownMotion) -> Iterator[FrameCorrection]:
    """Streams that are not the rate which another stream shows: no axes or signs mend them, and they are not used."""
    if _yaw_is_in_degrees(motion):
        because = "it turns as many times too fast as a radian has degrees, beside the gyroscope and its own course"
        yield FrameCorrection("pose", "its yaw is in degrees instead of radians", because, CERTAIN, None, np.zeros(0))
        return
    logs = [(topic, moved * np.exp(1j * motion.yaw)) for topic, moved in motion.moved.items()]
    other_velocity = "it is not the velocity of the poses in any axes"
    other_rate = "its yaw rate is not the rate at which the heading turns"
    relations = (
        ("imu", other_rate, motion.gyro, "the poses show", motion.turn),
        ("imu", other_rate, motion.gyro, "the compass shows", motion.swing),
        ("compass", "it does not turn as the poses do", motion.swing, "the poses show", motion.turn),
        *((topic, other_velocity, moved, "the poses show", motion.course) for topic, moved in logs),
    )
    found: set[str] = set()
    for topic, wrong, seen, shows, shown in relations:
        share = _share_of_another(seen, shown, motion)
        if topic not in found and share is not None:
            found.add(topic)
            because = f"of the motion that {shows} it has {share:.2f} times the amount"
            yield FrameCorrection(topic, wrong, because, CERTAIN, None, np.zeros(0))


def _yaw_is_in_degrees(motion: ShownMotion) -> bool:
    """Tell whether the yaw of the poses turns as degrees would, by the gyroscope and by the direction of the course.

    It cannot be put right: a yaw in degrees that was wrapped as radians has lost its full turns.
    """
    rates = abs(correlation(motion.turn, motion.gyro).real)
    enough = independent(motion.turn, motion.gyro, noise_weight(motion)) >= KINEMATICS.fewest
    low, high = UNITS.degrees
    if not (enough and rates > KINEMATICS.exact and low < abs(slope(motion.turn, motion.gyro)) < high):
        return False
    along = np.where(np.abs(motion.course) > 0.0, np.angle(motion.course), np.nan)
    as_degrees, as_given = (abs(alignment(along, factor * motion.yaw)) for factor in (np.pi / 180.0, 1.0))
    return as_degrees > as_given


def _share_of_another(seen: Numbers, shown: Numbers, motion: ShownMotion) -> float | None:
    """Amount of the shown motion that a stream reads, if it is clearly another motion; its own noise is no reason."""
    if independent(seen, shown, noise_weight(motion)) < KINEMATICS.fewest or not is_smooth(shown):
        return None
    share, error = _follows(seen, shown, motion)
    return abs(share) if error < KINEMATICS.sure and abs(share - 1.0) > KINEMATICS.other else None


def is_smooth(values: Numbers) -> bool:
    """Tell whether a series shows motion rather than noise: what it does two moments later is nearly the same.

    Moments share readings with their neighbours, but not with the next but one.
    """
    moved = values - _mean(values)
    given = both_given(moved[2:], moved[:-2])
    if not given.any():
        return False
    size = float(np.mean(np.abs(moved[np.isfinite(moved)]) ** 2))
    related = float(np.mean((moved[2:][given] * np.conj(moved[:-2][given])).real))
    return size > 0.0 and related > KINEMATICS.smooth * size


def _follows(seen: Numbers, shown: Numbers, motion: ShownMotion) -> tuple[complex, float]:
    """Share of the shown motion that a stream reads, 1 if it is the same, at the lag that fits best, and its error."""
    most = int(np.ceil(KINEMATICS.latest / motion.width))
    found = (_share(seen, shown, lag, noise_weight(motion)) for lag in range(-most, most + 1))
    return min(found, key=lambda share: share[1])


def _share(seen: Numbers, shown: Numbers, lag: int, weight: float) -> tuple[complex, float]:
    """Regression of what was read `lag` moments later on what is shown, means left out: share, standard error."""
    left, right = (seen[lag:], shown[: len(shown) - lag]) if lag >= 0 else (seen[:lag], shown[-lag:])
    given = both_given(left, right)
    if np.count_nonzero(given) < KINEMATICS.fewest:
        return 0j, np.inf
    a, b = left[given] - left[given].mean(), right[given] - right[given].mean()
    size = float((np.abs(b) ** 2).sum())
    if not size > 0.0:
        return 0j, np.inf
    share = complex((a * np.conj(b)).sum() / size)
    error = float(np.sqrt((np.abs(a - share * b) ** 2).mean() / (size * weight)))
    return share, error


def _mean(values: Numbers) -> complex | float:
    given = values[np.isfinite(values)]
    return given.mean() if given.size else 0.0
