"""Intervals of errors by drawing stretches of the recordings again."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers

SAMPLES = 400


def drawn(rng: np.random.Generator, stretches: int) -> Integers:
    """(SAMPLES, stretches) which of the stretches each sample is made of."""
    return rng.integers(0, stretches, (SAMPLES, stretches))


def interval_of_root(squared: Floats, draws: Integers) -> tuple[float, float]:
    """95 % interval of the root mean square whose squares are the means of the stretches (stretches,)."""
    low, high = np.sqrt(np.percentile(squared[draws].mean(axis=1), [2.5, 97.5]))
    return float(low), float(high)
