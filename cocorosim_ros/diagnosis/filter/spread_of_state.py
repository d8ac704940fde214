"""The covariance of a filter, with what the random force lets into it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import RMS_LEVEL, RMS_UPRIGHT, RMS_YAW, WANDERING
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.blocks import HFX, HFY, HN, HORIZONTAL, VERTICAL, VFZ, VW


class Spread(NamedTuple):
    """The covariance with its slopes and transitions, all flat."""

    wide: Floats  # (HORIZONTAL, HORIZONTAL)
    wide_slope: Floats  # (HFX, HORIZONTAL)
    wide_step: Floats  # (HORIZONTAL, HORIZONTAL)
    back: Floats  # (HORIZONTAL, HORIZONTAL) transpose of wide_step
    high: Floats  # (VERTICAL, VERTICAL)
    high_slope: Floats  # (VFZ, VERTICAL)
    high_step: Floats  # (VERTICAL, VERTICAL)
    response: Floats  # (4 + 9,) acceleration by unit of force along each axis, and (3, 3) of surge, sway and yaw, flat


class NewVariance(NamedTuple):
    """Variance of a random force and its gust, for a force with an rms of 1."""

    force: float
    both: float  # covariance
    gust: float


@allocating_kernel
def make_spread(deviation: Floats, noise: Floats, new: NewVariance) -> Spread:
    """Start the covariance from the standard deviation of the state (8,) and from the random force (PassNumbers)."""
    wide, high = np.zeros(HORIZONTAL * HORIZONTAL), np.zeros(VERTICAL * VERTICAL)
    places = (X, Y, YAW, SURGE, SWAY, YAW_RATE)
    for i in range(6):
        wide[i * HORIZONTAL + i] = deviation[places[i]] ** 2
    high[0], high[VW * VERTICAL + VW] = deviation[Z] ** 2, deviation[HEAVE] ** 2
    size = HORIZONTAL * HORIZONTAL
    parts = Spread(
        wide,
        np.zeros(HFX * HORIZONTAL),
        np.zeros(size),
        np.zeros(size),
        high,
        np.zeros(VFZ * VERTICAL),
        np.zeros(VERTICAL * VERTICAL),
        np.zeros(4 + 9),
    )
    add_force(parts, noise, new)
    return parts


@kernel
def _add_pair(matrix: Floats, at: int, size: int, apart: int, rms: float, new: NewVariance) -> None:
    """Let variance into the force that stands at `at` of a matrix (size, size), and into its gust, `apart` further."""
    other = at + apart
    matrix[at * size + at] += rms * rms * new.force
    matrix[at * size + other] += rms * rms * new.both
    matrix[other * size + at] += rms * rms * new.both
    matrix[other * size + other] += rms * rms * new.gust


@kernel
def add_force(parts: Spread, noise: Floats, new: NewVariance) -> None:
    """Let variance into the random forces."""
    _add_pair(parts.wide, HFX, HORIZONTAL, 3, noise[RMS_LEVEL], new)
    _add_pair(parts.wide, HFY, HORIZONTAL, 3, noise[RMS_LEVEL], new)
    _add_pair(parts.wide, HN, HORIZONTAL, 3, noise[RMS_YAW], new)
    _add_pair(parts.high, VFZ, VERTICAL, 1, noise[RMS_UPRIGHT], new)


@kernel
def let_wander(parts: Spread, noise: Floats, step: float) -> None:
    """Let variance of a step [s] into the place, where the one that an instrument shows wanders."""
    added = noise[WANDERING] * noise[WANDERING] * step
    parts.wide[X * HORIZONTAL + X] += added
    parts.wide[Y * HORIZONTAL + Y] += added


@kernel
def swollen(new: NewVariance, swell: Floats, point: int) -> NewVariance:
    """The variance that comes in over the step from `point` on, by what the random force is greater there."""
    if swell.shape[0] == 0:
        return new
    return NewVariance(new.force * swell[point], new.both * swell[point], new.gust * swell[point])
