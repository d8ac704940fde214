"""The unknowns of a fit, each with its owner, and their places in the rows of the tracks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats

PLATFORM, RANDOM_FORCE, READING = "platform", "random", "reading"
"""Owners of numbers that every model has: the platform, the random force of the water, the noise of readings."""


@dataclass(frozen=True)
class Owner:
    """The effect that an unknown belongs to, the robots on which it acts, and its name and unit in the contract."""

    effect: str  # identifier of the catalogue, or PLATFORM, RANDOM_FORCE, READING
    robots: tuple[str, ...]
    parameter: str
    unit: str  # of the number; for noise, of which the logarithm is fitted, the unit of the noise itself
    topic: str | None = None  # the stream, for an effect that each stream may have by itself


@dataclass(frozen=True)
class Unknown:
    """One number of some tracks, fitted as q: value = base * exp(scale * q) where logarithmic, base + scale * q else.

    One `on_top` does not replace the number that other unknowns give these tracks: it is a factor of that number where
    logarithmic, and is added to it else. So it is the difference of these tracks from others that share the number.
    `prior` is the standard deviation of q around 0 (around `centre`); `step` of q for slopes; q stays in `bounds`.
    """

    owner: Owner
    column: str
    tracks: tuple[int, ...]
    base: float
    scale: float = 1.0
    logarithmic: bool = False
    prior: float = math.inf
    centre: float = 0.0
    step: float = 0.01
    bounds: tuple[float, float] = (-math.inf, math.inf)
    on_top: bool = False

    def value(self, q: float) -> float:
        """Value of the number at q."""
        return self.base * math.exp(self.scale * q) if self.logarithmic else self.base + self.scale * q

    def slope(self, q: float) -> float:
        """Derivative of the number by q."""
        return self.scale * self.value(q) if self.logarithmic else self.scale

    def clipped(self, q: float) -> float:
        """Clip q to its bounds."""
        return min(max(q, self.bounds[0]), self.bounds[1])

    def inward_step(self, q: float) -> float:
        """Step of q for slopes, backwards where a step forwards would leave the bounds."""
        return self.step if self.clipped(q + self.step) == q + self.step else -self.step


def write_values(rows: Floats, unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """Copy rows (tracks, columns), with the values of the unknowns at q (n,) written in, those on top last."""
    filled = rows.copy()
    tops = []
    for unknown, number in zip(unknowns, q, strict=True):
        if unknown.on_top:
            tops.append((unknown, unknown.value(float(number))))
        else:
            filled[list(unknown.tracks), COLUMN[unknown.column]] = unknown.value(float(number))
    for unknown, value in tops:
        place = np.ix_(unknown.tracks, [COLUMN[unknown.column]])
        filled[place] = filled[place] * value if unknown.logarithmic else filled[place] + value
    return filled


def nudged(row: Floats, unknown: Unknown, q: float, step: float) -> Floats:
    """Copy one track's row (columns,), an unknown of that track moved from q to q + step."""
    other = row.copy()
    place, before, after = COLUMN[unknown.column], unknown.value(q), unknown.value(q + step)
    if not unknown.on_top and row[place] == before:
        other[place] = after
    else:  # what stands on top of the number, or below it, stays
        other[place] = row[place] * (after / before) if unknown.logarithmic else row[place] + (after - before)
    return other


def prior_precision(unknowns: Sequence[Unknown]) -> Floats:
    """Precisions (n,) of the priors of q, one over the variance; 0 for a flat prior."""
    return np.array([0.0 if math.isinf(unknown.prior) else unknown.prior**-2 for unknown in unknowns])


def prior_centre(unknowns: Sequence[Unknown]) -> Floats:
    """Centres (n,) of the priors of q."""
    return np.array([unknown.centre for unknown in unknowns])
