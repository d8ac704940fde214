"""The unknowns of a fit, each with its owner, and their places in the rows of the tracks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import norm

from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.foundation.arrays import Flags, Floats

Z95 = float(norm.ppf(0.975))
"""Standard deviations from the middle of a normal distribution to an end of its 95 % interval."""
PLATFORM, RANDOM_FORCE, READING = "platform", "random", "reading"
"""Owners of numbers that every model has: the platform, the random force of the water, the noise of readings."""


def deviation(low: float, high: float) -> float:
    """Standard deviation of a normal distribution with this 95 % interval."""
    return (high - low) / (2.0 * Z95)


def log_deviation(low: float, high: float) -> float:
    """Standard deviation of the logarithm of a number with this 95 % interval, both ends above zero."""
    return math.log(high / low) / (2.0 * Z95)


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
    `stated` is the standard deviation of q with which the platform's file gives the number, 0 if it gives none.
    The prior is normal; that of a number of the platform has heavy tails beyond one standard deviation (`log_prior`).
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
    stated: float = 0.0

    def value(self, q: float) -> float:
        """Value of the number at q."""
        return self.base * math.exp(self.scale * q) if self.logarithmic else self.base + self.scale * q

    def alone(self, q: float, neutral: float) -> float:
        """Value at q; of a difference that is added to a number, that number if it were `neutral` without it."""
        return self.value(q) + (neutral if self.on_top and not self.logarithmic else 0.0)

    def slope(self, q: float) -> float:
        """Derivative of the number by q."""
        return self.scale * self.value(q) if self.logarithmic else self.scale

    def clipped(self, q: float) -> float:
        """Clip q to its bounds."""
        return min(max(q, self.bounds[0]), self.bounds[1])

    def inward_step(self, q: float, step: float | None = None) -> float:
        """Step of q for slopes, its own or another, backwards where a step forwards would leave the bounds."""
        step = self.step if step is None else step
        return step if self.clipped(q + step) == q + step else -step

    def at_ends(self, q: float) -> tuple[bool, bool]:
        """Tell whether q stands at its lower bound, and whether at its upper one."""
        low, high = self.bounds
        return q - low < STEPS.at_bound, high - q < STEPS.at_bound


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


def prior_weights(unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """Weights (n,) by which the priors pull at q (n,): their log density falls by weight * (q - centre) for each q.

    That is the precision of a normal prior. The prior of a number of the platform is Huber's density: normal up to one
    standard deviation, exponential beyond. So its pull grows no further, and a number that the recordings have moved
    far stays where they put it when a later fit begins there. With a normal prior, a fit that begins at the result of
    another one would go further, and so would the next.
    Source: Huber, Ann. Math. Statist. 35 (1964) 73, equation 2.12, with k = 1.
    """
    weights = prior_precision(unknowns)
    far = _is_far(unknowns, q)
    weights[far] = np.sqrt(weights[far]) / np.abs(q - prior_centre(unknowns))[far]
    return weights


def prior_slope(unknowns: Sequence[Unknown], q: Floats) -> Floats:
    """Slope (n,) of the log density of the priors at q (n,)."""
    return np.asarray(-prior_weights(unknowns, q) * (q - prior_centre(unknowns)))


def log_prior(unknowns: Sequence[Unknown], q: Floats) -> float:
    """Log density of the priors at q (n,) [nats], over that at their centres; see `prior_weights`."""
    squares = prior_precision(unknowns) * (q - prior_centre(unknowns)) ** 2
    far = _is_far(unknowns, q)
    squares[far] = 2.0 * np.sqrt(squares[far]) - 1.0
    return -0.5 * float(np.sum(squares))


def _is_far(unknowns: Sequence[Unknown], q: Floats) -> Flags:
    """Flags (n,) of the numbers of a platform that lie farther from the centre than one standard deviation."""
    of_platform = np.array([unknown.owner.effect == PLATFORM for unknown in unknowns], dtype=bool)
    widths = np.array([unknown.prior for unknown in unknowns])
    return np.asarray(of_platform & (np.abs(q - prior_centre(unknowns)) > widths))


def prior_centre(unknowns: Sequence[Unknown]) -> Floats:
    """Centres (n,) of the priors of q."""
    return np.array([unknown.centre for unknown in unknowns])
