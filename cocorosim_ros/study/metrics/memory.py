"""What the metrics remember from tick to tick."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers

CONTACT_KINDS = 3
"""Ways of being in contact that the lost counters tell apart."""


class Memory(NamedTuple):
    """What the metrics of `runs` swarms of `robots` robots remember from tick to tick; changed in place."""

    position: Floats
    """(runs, robots, 3) at the previous tick [m; world]."""
    present: Flags
    """(runs, robots) at the previous tick."""
    centre: Floats
    """(2, runs, 3) at the previous tick, mean and median of the present robots [m; world], NaN of nobody."""
    contact: Flags
    """(runs, robots, kinds) robot had contact when last seen."""
    lost: Integers
    """(runs, kinds) events so far."""


def new_memory(runs: int, robots: int) -> Memory:
    """Memory of swarms that have not been measured yet."""
    return Memory(
        np.zeros((runs, robots, 3)),
        np.zeros((runs, robots), np.bool_),
        np.full((2, runs, 3), np.nan),
        np.zeros((runs, robots, CONTACT_KINDS), np.bool_),
        np.zeros((runs, CONTACT_KINDS), np.int64),
    )
