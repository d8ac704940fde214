"""Direction of z in poses, velocities and the IMU, by pressure, pump and gravity."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES
from cocorosim_ros.diagnosis.evidence.frames.agreement import correlation, independent, nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import CERTAIN, Fault, FrameCorrection, affine
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import FELT
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform


@dataclass(frozen=True)
class FeltGravity:
    """The axis of the accelerometer (0, 1, 2 for x, y, z) along which it reads gravity, and the reading [m/s^2]."""

    axis: int
    reading: float


def height_upside_down(motion: ShownMotion) -> float:
    """Nats by which a z that points down fits pressure and commanded heave better; negative for a z that points up."""
    return _opposite(motion.climb, -motion.sinking, motion.weight) + _opposite(motion.climb, motion.dive, motion.weight)


def lift_upside_down(motion: ShownMotion, topic: str) -> float:
    """Nats by which a w that points down fits poses and commanded heave better; negative for a w that points up.

    topic: of the velocity, one of VELOCITIES.
    """
    lift = motion.lift[topic]
    return _opposite(lift, motion.climb, motion.weight) + _opposite(lift, motion.dive, motion.weight)


def gravity_of(logs: Sequence[RobotLog], platform: Platform) -> FeltGravity | None:
    """The gravity that an accelerometer reads; None if it reads none.

    By REP 145 the axis is the third, and the reading + 9.81 m/s^2 at rest.
    """
    mean = _mean_force(logs)
    if not np.isfinite(mean).all():
        return None
    axis = int(np.argmax(np.abs(mean)))
    if not abs(abs(mean[axis]) / platform.gravity - 1.0) < AXES.near_gravity:
        return None
    return FeltGravity(axis, float(mean[axis]))


def force_unit(logs: Sequence[RobotLog], platform: Platform) -> FrameCorrection | None:
    """The correction of an accelerometer that counts in g, or leaves gravity out; None for m/s^2 with gravity."""
    mean = _mean_force(logs)
    if not np.isfinite(mean).all() or gravity_of(logs, platform) is not None:
        return None
    total = float(np.sqrt((mean**2).sum()))
    if abs(total - 1.0) < AXES.near_gravity:
        because = f"at rest it reads {total:.3g} where gravity makes {platform.gravity:.2f} m/s^2"
        factors = np.diag([1.0, *[platform.gravity] * 3])
        return affine("imu", Fault("accelerations are in g instead of m/s^2", because), CERTAIN, factors)
    if total < AXES.near_gravity * platform.gravity:
        because = f"its mean is {total:.2g} m/s^2 where gravity makes {platform.gravity:.2f}"
        fault = Fault("gravity is left out of the accelerations", because)
        return affine("imu", fault, CERTAIN, np.eye(4), np.array([0.0, 0.0, 0.0, platform.gravity]))
    return None


def _mean_force(logs: Sequence[RobotLog]) -> Floats:
    """Medians (3,) of the accelerometer [its unit]; NaN without readings."""
    readings = [log.streams["imu"].value[:, FELT] for log in logs if "imu" in log.streams]
    if not readings:
        return np.full(3, np.nan)
    given = [column[np.isfinite(column)] for column in np.vstack(readings).T]
    return np.array([np.median(column) if column.size else np.nan for column in given])


def _opposite(left: Floats, right: Floats, weight: float) -> float:
    """Nats by which opposite signs fit better than equal ones."""
    found = correlation(left, right).real
    scores = np.square(np.maximum(np.array([found, -found]), 0.0))
    equal, opposite = nats_behind(scores, found**2, independent(left, right, weight))
    return float(equal - opposite)
