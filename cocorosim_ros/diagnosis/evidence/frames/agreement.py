"""Agreement of two series that should be the same, as a number between -1 and 1 and in nats."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.criteria.frames import AGREEMENT
from cocorosim_ros.foundation.arrays import Flags

Numbers = NDArray[Any]


def both_given(left: Numbers, right: Numbers) -> Flags:
    """Mask (n,) of the moments at which both series have a number."""
    return np.asarray(np.isfinite(left) & np.isfinite(right))


def independent(left: Numbers, right: Numbers, weight: float) -> float:
    """Count the moments at which both series (n,) have a value, times `weight`.

    weight: independent readings by reading, at most 1: neighbours in time are correlated.
    """
    return float(np.count_nonzero(both_given(left, right)) * weight)


def correlation(left: Numbers, right: Numbers) -> complex:
    """Correlation of real or complex numbers without their means, extremes cut; 0 where either series is constant.

    The phase of the correlation is the angle by which `left` is turned from `right`.
    """
    given = both_given(left, right)
    if np.count_nonzero(given) < 3:
        return 0j
    a, b = (_tamed(side[given] - side[given].mean()) for side in (left, right))
    scale = np.sqrt((np.abs(a) ** 2).sum() * (np.abs(b) ** 2).sum())
    return complex((a * np.conj(b)).sum() / scale) if scale > 0.0 else 0j


def _tamed(values: Numbers) -> Numbers:
    """Cut numbers whose length is far above that of most others, so that a few faulty readings do not decide."""
    length = np.abs(values)
    longest = AGREEMENT.extreme * float(np.quantile(length, AGREEMENT.most))
    return np.asarray(values * np.minimum(1.0, longest / np.maximum(length, 1e-300)))


def slope(left: Numbers, right: Numbers) -> float:
    """Ratio of the spreads of `left` and `right`, with the sign of their correlation."""
    given = both_given(left, right)
    if np.count_nonzero(given) < 3 or not np.std(right[given]) > 0.0:
        return float("nan")
    sign = np.sign(correlation(left, right).real)
    return float(sign * np.std(left[given]) / np.std(right[given]))


def alignment(left: Numbers, right: Numbers) -> complex:
    """Mean of exp(i (left - right)) of two angles; its phase is their difference, its length 1 if that is constant."""
    given = both_given(left, right)
    return complex(np.exp(1j * (left[given] - right[given])).mean()) if given.any() else 0j


def nats_behind(score: Numbers, best: float, count: float) -> Numbers:
    """Nats by which explanations with these scores are behind the best one: n/2 ln((1 - score)/(1 - best))."""
    if best < AGREEMENT.clear or count < AGREEMENT.fewest:
        return np.zeros_like(score)
    left = np.maximum(1.0 - np.maximum(score, 0.0), AGREEMENT.finest)
    return np.asarray(0.5 * count * np.log(left / max(1.0 - best, AGREEMENT.finest)))
