"""The numbers that a fit is to find, and how they stand in the rows of the tracks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Floats

PLATFORM, RANDOM_FORCE, READING = "platform", "random", "reading"
"""Effects of numbers that every model has: the platform's own, the water's random force, the noise of readings."""


@dataclass(frozen=True)
class Owner:
    """The effect that an unknown belongs to, the robots on which it acts, and its name and unit in the contract."""

    effect: str  # identifier of the catalogue, or PLATFORM, RANDOM_FORCE, READING
    robots: tuple[str, ...]
    parameter: str
    unit: str  # of the number; for noise, whose logarithm is fitted, of that of which it is the logarithm
    topic: str | None = None  # of an effect that may be of one stream or another


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
        """The number itself."""
        return self.base * math.exp(q) if self.logarithmic else self.base + self.scale * q

    def slope(self, q: float) -> float:
        """Derivative of the number by q."""
        return self.value(q) if self.logarithmic else self.scale

    def clipped(self, q: float) -> float:
        """q within its bounds."""
        return min(max(q, self.bounds[0]), self.bounds[1])

    def inward_step(self, q: float) -> float:
        """The step of q for slopes, backwards where a step forwards would leave the bounds."""
        return self.step if self.clipped(q + self.step) == q + self.step else -self.step


def write_values(rows: Floats, unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """(tracks, columns) a copy of `rows` with the values of the unknowns."""
    filled = rows.copy()
    for unknown, number in zip(unknowns, q, strict=True):
        filled[list(unknown.tracks), COLUMN[unknown.column]] = unknown.value(float(number))
    return filled


def nudged(row: Floats, unknown: Unknown, q: float) -> Floats:
    """(columns,) a copy of one track's row with another value of an unknown of that track."""
    other = row.copy()
    other[COLUMN[unknown.column]] = unknown.value(q)
    return other


def prior_precision(unknowns: Sequence[Unknown]) -> Floats:
    """(n,) of q."""
    return np.array([0.0 if math.isinf(unknown.prior) else unknown.prior**-2 for unknown in unknowns])


def prior_centre(unknowns: Sequence[Unknown]) -> Floats:
    """(n,) of q."""
    return np.array([unknown.centre for unknown in unknowns])
