"""Straight lines and means through numbers with intervals, where they scatter by more than their intervals say.

    y_i = X_i b + s_i + e_i        e_i: of variance spread_i^2, known; s_i: of variance scatter^2, the same for all

scatter^2 is the one with which the weighted squares of what the line leaves over are as many as there are degrees of
freedom (Paule and Mandel, J. Res. NBS 87 (1982) 377), none where they are fewer anyway; intervals are those of
Student's distribution with these degrees of freedom (Knapp and Hartung, Statistics in Medicine 22 (2003) 2693, whose
factor is one here, and never less).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.stats import t as student

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class Line:
    """A fit: coefficients (p,), their covariance (p, p), the scatter beyond the intervals, degrees of freedom."""

    coefficients: Floats
    covariance: Floats
    scatter: float
    freedom: int

    def error(self, direction: Floats) -> float:
        """Standard error of a combination (p,) of the coefficients."""
        return math.sqrt(float(direction @ self.covariance @ direction))

    @property
    def quantile(self) -> float:
        """Half a 95 % interval, in standard errors."""
        return float(student.ppf(0.975, self.freedom))

    def estimate(self, index: int, unit: str, shown: Callable[[float], float] = float) -> Estimate:
        """A coefficient and its 95 % interval, each turned by a rising function into what it is shown as."""
        value = float(self.coefficients[index])
        half = self.quantile * math.sqrt(float(self.covariance[index, index]))
        return Estimate(shown(value), shown(value - half), shown(value + half), unit)

    def chance(self, index: int) -> float:
        """Probability of a coefficient at least as far from zero if it is zero: the p of a two-sided test."""
        size = abs(float(self.coefficients[index])) / math.sqrt(float(self.covariance[index, index]))
        return float(2.0 * student.sf(size, self.freedom))


def fitted_line(design: Floats, value: Floats, spread: Floats) -> Line | None:
    """Fit values (n,) with standard deviations (n,) by a design (n, p); None if it cannot be told from them.

    For that there have to be more values than coefficients, and places that tell the coefficients apart.
    """
    count, wanted = design.shape
    if count <= wanted or np.linalg.matrix_rank(design) < wanted:
        return None
    scatter = math.sqrt(_excess(design, value, spread))
    weight = 1.0 / (np.square(spread) + scatter**2)
    covariance = np.linalg.inv(design.T @ (weight[:, None] * design))
    return Line(covariance @ design.T @ (weight * value), np.asarray(covariance, float), scatter, count - wanted)


def _excess(design: Floats, value: Floats, spread: Floats) -> float:
    """Variance of the scatter."""
    freedom: int = design.shape[0] - design.shape[1]

    def surplus(variance: float) -> float:
        return _squares(design, value, np.square(spread) + variance) - freedom

    # With such a variance even the squares of the line with equal weights are too few: none is left over there.
    most = 2.0 * _squares(design, value, np.ones_like(value)) / freedom
    if surplus(0.0) <= 0.0 or most <= 0.0:
        return 0.0
    return float(np.asarray(brentq(surplus, 0.0, most, xtol=1e-12 * most)))


def _squares(design: Floats, value: Floats, variance: Floats) -> float:
    """Weighted squares of what the best line leaves over."""
    root = 1.0 / np.sqrt(variance)
    scaled = root[:, None] * design
    best, *_ = np.linalg.lstsq(scaled, root * value, rcond=None)
    return float(np.sum(np.square(root * value - scaled @ best)))
