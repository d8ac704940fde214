"""Vargha-Delaney A: the probability that a run of one group has the larger value than a run of another.

A = P(X > Y) + P(X = Y) / 2. In the paper an effect is large from 0.71 or below 0.29; Read et al. 2011 (table 1)
give 0.56 and 0.64 for small and medium.
Sources: Vargha & Delaney 2000, J. Educational and Behavioral Statistics 25(2):101-132; Brunner & Munzel 2000,
Biometrical Journal 42:17-25; Newcombe 2006, Statistics in Medicine 25:559-573 (method 5).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy import optimize, stats

from cocorosim_ros.foundation.arrays import Floats

SMALL, MEDIUM, LARGE = 0.56, 0.64, 0.71


@dataclass(frozen=True)
class Effect:
    """A of a sample against another, with its two-sided interval of confidence."""

    value: float
    low: float
    high: float

    @property
    def size(self) -> str:
        """`none`, `small`, `medium` or `large`; `undefined` without values."""
        if math.isnan(self.value):
            return "undefined"
        # Rounded where 1 - A would miss a threshold by the last bit: 1 - 0.29 is less than 0.71.
        folded = round(max(self.value, 1.0 - self.value), 12)
        return "large" if folded >= LARGE else "medium" if folded >= MEDIUM else "small" if folded >= SMALL else "none"

    @property
    def direction(self) -> str:
        """`higher`, `lower` or `same`: where the first sample lies."""
        return "higher" if self.value > 0.5 else "lower" if self.value < 0.5 else "same"


def vargha_delaney(first: Floats, second: Floats) -> float:
    """A of `first` (m,) against `second` (n,), exact up to one rounding; NaN if one is empty. NaNs must be out.

    It equals (2 R1 - m (m + 1)) / (2 m n) with the rank sum R1 of the first, and is counted in whole numbers.
    """
    if first.size == 0 or second.size == 0:
        return math.nan
    ordered = np.sort(second)
    twice = np.searchsorted(ordered, first, "left").sum() + np.searchsorted(ordered, first, "right").sum()
    return int(twice) / (2 * first.size * second.size)


def effect(first: Floats, second: Floats, confidence: float = 0.95) -> Effect:
    """A with its interval; undefined values (NaN) are left out.

    The interval is Brunner and Munzel's on the logit scale, and Newcombe's where the samples do not overlap or the
    variance cannot be estimated.
    """
    first, second = first[~np.isnan(first)], second[~np.isnan(second)]
    value = vargha_delaney(first, second)
    if math.isnan(value):
        return Effect(math.nan, math.nan, math.nan)
    variance, freedom = _placement_variance(first, second)
    if variance <= 0.0 or not 0.0 < value < 1.0:
        return Effect(value, *_newcombe(value, first.size, second.size, confidence))
    reach = stats.t.ppf(0.5 + confidence / 2, freedom) * math.sqrt(variance) / (value * (1.0 - value))
    middle = math.log(value / (1.0 - value))
    return Effect(value, _logistic(middle - reach), _logistic(middle + reach))


def _placement_variance(first: Floats, second: Floats) -> tuple[float, float]:
    """Variance of A by the spread of each value's place in the other sample, and its degrees of freedom."""
    if first.size < 2 or second.size < 2:
        return 0.0, 1.0
    shares = [_places(first, second).var(ddof=1) / first.size, _places(second, first).var(ddof=1) / second.size]
    total = float(sum(shares))
    if total == 0.0:
        return 0.0, 1.0
    return total, total**2 / (shares[0] ** 2 / (first.size - 1) + shares[1] ** 2 / (second.size - 1))


def _places(values: Floats, among: Floats) -> Floats:
    """The share of `among` below each value, half of the equal ones included."""
    ordered = np.sort(among)
    both = np.searchsorted(ordered, values, "left") + np.searchsorted(ordered, values, "right")
    places: Floats = both / (2.0 * among.size)
    return places


def _newcombe(value: float, m: int, n: int, confidence: float) -> tuple[float, float]:
    """The A's whose own standard error just reaches to `value`."""
    z = float(stats.norm.ppf(0.5 + confidence / 2))
    others = (m + n) / 2 - 1

    def excess(a: float) -> float:
        variance = a * (1 - a) * (1 + others * ((1 - a) / (2 - a) + a / (1 + a))) / (m * n)
        return (a - value) ** 2 - z * z * variance

    edge = 1e-12
    low = float(optimize.brentq(excess, edge, value - edge)) if value > 2 * edge else 0.0
    high = float(optimize.brentq(excess, value + edge, 1 - edge)) if value < 1 - 2 * edge else 1.0
    return low, high


def _logistic(x: float) -> float:
    return 1.0 / (1.0 + math.exp(-x))
