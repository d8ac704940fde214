"""Sizes that a number of a vehicle can have at all: ends of intervals and visible sizes further out are not told."""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.meaning import between
from cocorosim_ros.diagnosis.criteria.report import BELIEVABLE
from cocorosim_ros.diagnosis.findings import Estimate

_MOST = {
    "1": BELIEVABLE.ratio,
    "m": BELIEVABLE.length,
    "s": BELIEVABLE.time,
    "rad": BELIEVABLE.angle,
    "kg": BELIEVABLE.mass,
    "m/s": BELIEVABLE.speed,
    "m/s^2": BELIEVABLE.acceleration,
    "rad/s": BELIEVABLE.yaw_rate,
    "1/s": BELIEVABLE.shear,
    "s/m": BELIEVABLE.slowness,
    "s/s": BELIEVABLE.clock_rate,
    "Pa": BELIEVABLE.pressure,
    "Pa/s": BELIEVABLE.pressure_rate,
    "N": BELIEVABLE.force,
    "N s/m": BELIEVABLE.linear_drag,
    "N/m": BELIEVABLE.stiffness,
}
"""Largest amount that a number can have, by its SI unit."""


def is_believable(value: float, unit: str) -> bool:
    """Tell whether a number of this SI unit is one that a vehicle, its water or its instruments can have."""
    return math.isfinite(value) and abs(value) <= _MOST.get(unit, math.inf)


def is_possible_size(effect: str, number: str, size: float, unit: str) -> bool:
    """Tell whether a number of an effect can be `size` more than where it does nothing [SI unit]."""
    return is_believable(size, unit) and size <= between(f"{effect}.{number}")[1]


class Ends(NamedTuple):
    """The ends of an interval; infinite where an end is not told, NaN where the interval is not known."""

    low: float
    high: float


def told_ends(estimate: Estimate) -> Ends:
    """The ends of an interval that tell something, no further than the number's meaning allows.

    An end tells nothing beyond what is believable, nor where a number whose logarithm was fitted is unknown by factors.
    """
    low, high = _within(estimate)
    if not is_believable(low, estimate.unit) and not math.isnan(low):
        low = -math.inf
    if not is_believable(high, estimate.unit) and not math.isnan(high):
        high = math.inf
    value, spread = estimate.value, BELIEVABLE.spread
    # The ends of a logarithm's interval are the value over and times a factor, those of others lie as far from it.
    if 0.0 <= estimate.low <= estimate.high and estimate.high > spread * value:
        return Ends(low if value < spread * estimate.low else -math.inf, math.inf)
    return Ends(low, high)


def _within(estimate: Estimate) -> tuple[float, float]:
    least, most = estimate.between
    low = max(estimate.low, least) if estimate.value >= least else estimate.low
    high = min(estimate.high, most) if estimate.value <= most else estimate.high
    return low, high
