"""Readings that nothing measured: interpolated between others, or the last one repeated by a logger that runs faster.

They agree with their neighbours far better than the instrument does, so that noise judged from them is far too small,
and they count as evidence without being any.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import FILLED_IN, NOISE
from cocorosim_ros.diagnosis.evidence.streams.levels import steps_between
from cocorosim_ros.foundation.arrays import Flags, Floats


def filled_in(time: Floats, value: Floats, turn: float = 0.0) -> Flags:
    """Flags (n,) of the readings that lie on the straight line between their neighbours, or repeat the last one.

    time (n,) [s] ascending, value (n,), NaN where not given; turn: a full turn [unit of value] of angles, 0 for what is
    none. None is flagged unless such readings are many, lie among others that miss the line by far, and are no result
    of rounding: a robot at rest, or in steady motion without noise, has many in a row; a coarse instrument misses the
    line by a few of its steps.
    """
    flags = np.zeros(len(value), dtype=bool)
    given = np.flatnonzero(np.isfinite(value))
    if len(given) < FILLED_IN.fewest:
        return flags
    shown = value[given]
    exact = FILLED_IN.exact * float(np.ptp(shown))
    steps = steps_between(shown, exact, turn)
    if len(steps) + 1 < FILLED_IN.fewest:  # an instrument of so few levels repeats itself
        return flags
    tolerance = max(FILLED_IN.on_the_line * float(steps.min()), exact)
    off, step = _off_the_line(time[given], shown), np.abs(np.diff(shown))[:-1]
    for size, limit in ((step, NOISE.finest_of_turn * turn), (off, tolerance)):
        if _are_many_among_others(size <= limit, size, tolerance):
            flags[given[1:-1]] = size <= limit
            return flags
    return flags


def _off_the_line(time: Floats, value: Floats) -> Floats:
    """Distances (n - 2,) of readings from the line through their neighbours."""
    middle = (time[1:-1] - time[:-2]) / (time[2:] - time[:-2])
    return np.abs(value[1:-1] - (value[:-2] + middle * (value[2:] - value[:-2])))


def _are_many_among_others(small: Flags, size: Floats, tolerance: float) -> bool:
    """Tell whether readings are small in many places, and the others so large that no rounding makes the difference."""
    share, turns = float(np.mean(small)), float(np.mean(small[1:] != small[:-1]))
    if not FILLED_IN.least < share < 1.0 or turns < FILLED_IN.turns:
        return False
    return float(np.median(size[~small])) > FILLED_IN.steps * tolerance
