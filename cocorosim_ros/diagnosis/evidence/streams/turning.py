"""Unwrapping of angles: readings that jump from one end of the circle to the other go on counting."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import TURNING
from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import TURN_RATE
from cocorosim_ros.foundation.arrays import Flags, Floats

FULL_TURN = 2.0 * np.pi
STEP = 1.0  # s over which turns are compared


@dataclass(frozen=True)
class TurnedAngle:
    """A continuous angle (m,) of a stream, at times (m,) [s]."""

    time: Floats
    angle: Floats


def period_of(angle: Floats) -> float:
    """A full turn in the unit of these readings: 2 pi, or 360 where they exceed any angle in radians."""
    given = angle[np.isfinite(angle)]
    beyond = given.size > 0 and np.abs(given).max() > FULL_TURN + TURNING.beyond_a_turn
    return 360.0 if beyond else FULL_TURN


def unwrapped(time: Floats, angle: Floats, period: float = FULL_TURN, turned: TurnedAngle | None = None) -> Floats:
    """Angle (n,) without jumps of a period; NaN where it is not given.

    turned: the angle of another stream, same unit; over a gap of the readings the
    number of turns that comes closest to this stream is taken. Without it, the shortest way is taken.
    """
    result = np.full(angle.shape, np.nan)
    given = np.isfinite(angle)
    if not given.any():
        return result
    moments, wrapped = time[given], angle[given]
    expected = np.zeros(moments.size - 1)
    if turned is not None and len(turned.time) > 1:
        long = np.diff(moments) > TURNING.long
        other = np.interp(moments, turned.time, turned.angle)
        expected = np.where(long & _covered(moments, turned.time), np.diff(other), 0.0)
    steps = np.diff(wrapped)
    steps = expected + (steps - expected + period / 2) % period - period / 2
    result[given] = wrapped[0] + np.concatenate([[0.0], np.cumsum(steps)])
    return result


def _covered(moments: Floats, other: Floats) -> Flags:
    """Mask (n-1,) of the intervals between two moments throughout which the other stream has readings."""
    first, last = np.searchsorted(other, moments[:-1]), np.searchsorted(other, moments[1:])
    inside = last - first
    longest = np.zeros(inside.size)
    for index in np.flatnonzero((np.diff(moments) > TURNING.long) & (inside > 1)):
        around = other[max(first[index] - 1, 0) : last[index] + 1]
        longest[index] = np.diff(around).max()
    return np.asarray((inside > 1) & (longest < TURNING.long))


def turned_by_gyro(time: Floats, angle: Floats, imu: Stream | None) -> TurnedAngle | None:
    """The angle [unit of `angle`] from the gyroscope, if both agree where the angle has no gaps; else None."""
    given = np.isfinite(angle)
    if (
        imu is None
        or len(imu.time) < 3
        or np.count_nonzero(given) < 3
        or not np.isfinite(imu.value[:, TURN_RATE]).all()
    ):
        return None
    time, angle = time[given], angle[given]
    turned = _integral(imu)
    moments = np.arange(max(time[0], imu.time[0]), min(time[-1], imu.time[-1]), STEP)
    within = np.searchsorted(time, moments)
    longest = [np.diff(time[max(k - 1, 0) : m + 1]).max() for k, m in pairwise(within)]
    seen = np.array([gap < TURNING.long for gap in longest], dtype=bool)
    ours = np.diff(np.interp(moments, time, angle))[seen]
    theirs = np.diff(np.interp(moments, imu.time, turned))[seen]
    if len(ours) < TURNING.fewest or not ours.std() * theirs.std() > 0.0:
        return None
    if abs(np.corrcoef(ours, theirs)[0, 1]) < TURNING.follows:
        return None
    return TurnedAngle(imu.time, float((ours * theirs).sum() / (theirs * theirs).sum()) * turned)


def _integral(imu: Stream) -> Floats:
    steps, rate = np.diff(imu.time), imu.value[:, TURN_RATE]
    turns = 0.5 * (rate[1:] + rate[:-1]) * np.where(steps < TURNING.continuous, steps, 0.0)
    return np.concatenate([[0.0], np.cumsum(turns)])
