"""Axes of the IMU, from gravity, from the turning, and from the accelerations that commands or poses show."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES
from cocorosim_ros.diagnosis.evidence.frames.agreement import correlation, independent, nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import CERTAIN, Fault, FrameCorrection, affine
from cocorosim_ros.diagnosis.evidence.frames.expected import Complex
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, SAME, Turned, matrix_of
from cocorosim_ros.diagnosis.evidence.frames.upright import FeltGravity
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import FELT_X, FELT_Z, TURN_RATE

MIRRORED = Turned(mirrored=1, quarters=0)
OPPOSITE = Turned(mirrored=0, quarters=2)
UP = 2  # axis


def inertial_axes(motion: ShownMotion, gravity: FeltGravity | None, gyro_nats: float) -> FrameCorrection | None:
    """The correction of an IMU whose axes are not forward-left-up; None if they are.

    gravity: as the accelerometer reads it, None if it reads none. gyro_nats: nats by which the opposite sign of the yaw
    rate fits better, 0 if it fits worse.
    """
    if gravity is not None and gravity.axis != UP:
        because = f"gravity is felt along its {'xyz'[gravity.axis]} axis, {gravity.reading:.2f} m/s^2"
        wrong = "the IMU is mounted with another axis than z upwards; turn its readings into body axes"
        return FrameCorrection("imu", wrong, because, CERTAIN, None, np.zeros(4))
    over, backwards = gravity is not None and gravity.reading < 0.0, gyro_nats > 0.0
    turned, nats = _horizontal(motion)
    known = nats >= AXES.margin or turned == SAME
    if not (over or backwards or (known and turned != SAME)):
        return None
    if not known:  # without motion that shows them: the IMU as a whole is upside down, or they are right
        turned = MIRRORED if over and backwards else SAME
    matrix = np.eye(4)
    matrix[TURN_RATE, TURN_RATE], matrix[FELT_Z, FELT_Z] = (-1.0 if backwards else 1.0), (-1.0 if over else 1.0)
    matrix[FELT_X:FELT_Z, FELT_X:FELT_Z] = matrix_of(turned)
    seen = [f"gravity reads {gravity.reading:.2f} m/s^2 along z"] if gravity is not None and over else []
    seen += ["its yaw rate has the opposite sign of the others'"] if backwards else []
    seen += ["its accelerations fit the motion only so"] if known and turned != SAME else []
    fault = Fault(_words(turned, over, backwards), ", ".join(seen))
    return affine("imu", fault, _sum(over, gyro_nats, nats), matrix)


def _sum(over: bool, gyro_nats: float, nats: float) -> float:
    return CERTAIN if over else gyro_nats + nats


def _words(turned: Turned, over: bool, backwards: bool) -> str:
    if turned == MIRRORED and over and backwards:
        return "the IMU is in forward-right-down axes: the signs of y and z are flipped"
    if turned == OPPOSITE and over and not backwards:
        return "the accelerometer has the opposite sign: at rest it must read gravity upwards"
    parts = []
    if turned != SAME:
        rows = matrix_of(turned)
        axes = [f"{name} = {'-' if row.sum() < 0.0 else ''}{'xy'[int(np.abs(row).argmax())]}"
                for name, row in zip("xy", rows, strict=True)]  # fmt: skip
        parts.append(f"the horizontal axes of the accelerometer are turned ({', '.join(axes)})")
    parts += ["the sign of its z axis is flipped"] if over else []
    parts += ["the sign of the yaw rate is flipped"] if backwards else []
    return ", and ".join(parts)


def _horizontal(motion: ShownMotion) -> tuple[Turned, float]:
    """The turn of the horizontal axes that fits best, and its lead [nats] over leaving them as they are."""
    seen = motion.pulled
    shown = motion.shove if np.isfinite(motion.shove).any() else _body_acceleration(motion)
    scores = np.array([_score(seen, shown, turned) for turned in ALL_TURNED])
    behind = nats_behind(scores, float(scores.max()), independent(shown, seen, motion.weight))
    return ALL_TURNED[int(scores.argmax())], float(behind[0])


def _score(seen: Complex, shown: Complex, turned: Turned) -> float:
    found = correlation(1j**turned.quarters * (np.conj(seen) if turned.mirrored else seen), shown)
    return float(max(found.real, 0.0) ** 2)


def _body_acceleration(motion: ShownMotion) -> Complex:
    """Acceleration (n,) [m/s^2; body] of the poses, forward + i left, over the time of the mean of three readings."""
    result = np.full(len(motion.course), np.nan + 0.0j)
    result[1:-1] = (motion.course[2:] - motion.course[:-2]) / (2.0 * motion.width)
    return np.asarray(result * np.exp(-1j * motion.yaw))
