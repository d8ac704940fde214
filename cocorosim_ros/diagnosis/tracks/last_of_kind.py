"""The last reading of the same kind before each reading, as far as one is near."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers


def last_of_kind(kind: Integers, moment: Floats, farthest: float) -> tuple[Integers, Floats]:
    """Places (m,) of the readings of the same kind before, -1 where there is none within `farthest`, and gaps (m,) [s].

    kind (m,), moment (m,) [s]: of readings in the order of time, as far as those of one kind are concerned.
    """
    before, gap = np.full(len(kind), -1, dtype=np.int64), np.zeros(len(kind))
    for code in np.unique(kind):
        places = np.flatnonzero(kind == code)
        apart = np.diff(moment[places])
        near = apart <= farthest
        before[places[1:][near]] = places[:-1][near]
        gap[places[1:][near]] = apart[near]
    return before, gap
