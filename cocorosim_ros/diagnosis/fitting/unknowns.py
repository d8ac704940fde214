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
    """One number of some tracks, fitted as q: value = base * exp(q) where logarithmic, base + scale * q else.

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

    def value(self, q: float) -> float:
        """Value of the number at q."""
        return self.base * math.exp(q) if self.logarithmic else self.base + self.scale * q

    def slope(self, q: float) -> float:
        """Derivative of the number by q."""
        return self.value(q) if self.logarithmic else self.scale

    def clipped(self, q: float) -> float:
        """Clip q to its bounds."""
        return min(max(q, self.bounds[0]), self.bounds[1])

    def inward_step(self, q: float) -> float:
        """Step of q for slopes, backwards where a step forwards would leave the bounds."""
        return self.step if self.clipped(q + self.step) == q + self.step else -self.step


def write_values(rows: Floats, unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """Copy rows (tracks, columns), with the values of the unknowns at q (n,) written in."""
    filled = rows.copy()
    for unknown, number in zip(unknowns, q, strict=True):
        filled[list(unknown.tracks), COLUMN[unknown.column]] = unknown.value(float(number))
    return filled


def nudged(row: Floats, unknown: Unknown, q: float) -> Floats:
    """Copy one track's row (columns,), with the value at q of an unknown of that track written in."""
    other = row.copy()
    other[COLUMN[unknown.column]] = unknown.value(q)
    return other


def prior_precision(unknowns: Sequence[Unknown]) -> Floats:
    """Precisions (n,) of the priors of q, one over the variance; 0 for a flat prior."""
    return np.array([0.0 if math.isinf(unknown.prior) else unknown.prior**-2 for unknown in unknowns])


def prior_centre(unknowns: Sequence[Unknown]) -> Floats:
    """Centres (n,) of the priors of q."""
    return np.array([unknown.centre for unknown in unknowns])
