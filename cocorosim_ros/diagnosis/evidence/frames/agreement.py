"""How well two things that should be the same agree, in numbers between -1 and 1 and in nats."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.criteria.frames import AGREEMENT
from cocorosim_ros.foundation.arrays import Flags

Numbers = NDArray[Any]


def both_given(left: Numbers, right: Numbers) -> Flags:
    """(n,) where both are numbers."""
    return np.asarray(np.isfinite(left) & np.isfinite(right))


def independent(left: Numbers, right: Numbers, weight: float) -> float:
    """How many independent readings the two have in common, if each is worth `weight` of one."""
    return float(np.count_nonzero(both_given(left, right)) * weight)


def correlation(left: Numbers, right: Numbers) -> complex:
    """Of real or complex numbers, their means taken away, extremes cut; 0 where either does not vary.

    Its phase is the angle by which `left` is turned from `right`.
    """
    given = both_given(left, right)
    if np.count_nonzero(given) < 3:
        return 0j
    a, b = (_tamed(side[given] - side[given].mean()) for side in (left, right))
    scale = np.sqrt((np.abs(a) ** 2).sum() * (np.abs(b) ** 2).sum())
    return complex((a * np.conj(b)).sum() / scale) if scale > 0.0 else 0j


def _tamed(values: Numbers) -> Numbers:
    """The numbers with lengths cut to some times what most have, so that a few faults do not decide."""
    length = np.abs(values)
    longest = AGREEMENT.extreme * float(np.quantile(length, AGREEMENT.most))
    return np.asarray(values * np.minimum(1.0, longest / np.maximum(length, 1e-300)))


def slope(left: Numbers, right: Numbers) -> float:
    """How often `right` goes into `left`, by the ratio of their spreads; the sign is the correlation's."""
    given = both_given(left, right)
    if np.count_nonzero(given) < 3 or not np.std(right[given]) > 0.0:
        return float("nan")
    sign = np.sign(correlation(left, right).real)
    return float(sign * np.std(left[given]) / np.std(right[given]))


def alignment(left: Numbers, right: Numbers) -> complex:
    """Mean of exp(i (left - right)) of two angles: length 1 if their difference is constant, and that is its phase."""
    given = both_given(left, right)
    return complex(np.exp(1j * (left[given] - right[given])).mean()) if given.any() else 0j


def nats_behind(score: Numbers, best: float, count: float) -> Numbers:
    """By how much explanations with these scores are worse than the best one: n/2 ln((1 - score)/(1 - best))."""
    if best < AGREEMENT.clear or count < AGREEMENT.fewest:
        return np.zeros_like(score)
    left = np.maximum(1.0 - np.maximum(score, 0.0), AGREEMENT.finest)
    return np.asarray(0.5 * count * np.log(left / max(1.0 - best, AGREEMENT.finest)))
