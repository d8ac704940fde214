"""Chances of several tests at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats


def holm(chances: Sequence[float]) -> Floats:
    """Adjust the chances p (n,) of n tests by Holm's procedure (Scand. J. Statistics 6 (1979) 65).

    Those that are at most P after it can all be called clear: where nothing is there in any of the n tests, the
    probability of calling any clear is P at most, however the tests depend on each other.
    """
    order = np.argsort(chances, kind="stable")
    count = len(order)
    adjusted, least = np.zeros(count), 0.0
    for rank, index in enumerate(order):
        least = max(least, min(1.0, float(chances[index]) * (count - rank)))
        adjusted[index] = least
    return adjusted
