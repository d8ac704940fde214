"""Bootstrap intervals of errors: stretches of the recordings are drawn again, with replacement."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers

SAMPLES = 400


def drawn(rng: np.random.Generator, stretches: int) -> Integers:
    """Draw samples: the numbers (SAMPLES, stretches) of the stretches that each is made of."""
    return rng.integers(0, stretches, (SAMPLES, stretches))


def interval_of_root(squared: Floats, draws: Integers) -> tuple[float, float]:
    """95 % interval of a root mean square, by the mean squares of the stretches (stretches,) and draws of these."""
    low, high = np.sqrt(np.percentile(squared[draws].mean(axis=1), [2.5, 97.5]))
    return float(low), float(high)
