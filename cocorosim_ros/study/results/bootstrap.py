"""An interval for any number that is made from samples of runs: draw the runs again, with replacement, many times.

The interval is that of the percentiles. Of few runs it would be too narrow, and with fewer than six not even the whole
range of a sample holds its median in 95 % of all cases (1 - 2 / 2^5 = 94 %): then there is none.
Source: Efron & Tibshirani 1993, An Introduction to the Bootstrap, chapter 13.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats

LEAST = 6
_DRAWS, _CONFIDENCE = 2000, 0.95


def bootstrap_interval(
    samples: Sequence[Floats], statistic: Callable[..., Floats], seed: int = 0
) -> tuple[float, float]:
    """Low and high of `statistic`, NaN if a sample has fewer than six values; the same seed gives the same interval.

    Args:
        samples: each (runs,), without NaN; drawn from independently of each other.
        statistic: takes one array (draws, runs) for each sample and returns (draws,).
        seed: of the draws.
    """
    if min(sample.size for sample in samples) < LEAST:
        return math.nan, math.nan
    random = np.random.default_rng(seed)
    drawn = statistic(*(random.choice(sample, (_DRAWS, sample.size)) for sample in samples))
    low, high = np.quantile(drawn, [0.5 - _CONFIDENCE / 2, 0.5 + _CONFIDENCE / 2])
    return float(low), float(high)
