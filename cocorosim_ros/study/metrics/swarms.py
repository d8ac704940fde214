"""Many swarms at one moment, with the work that several metrics share: directions, distances, shoals,
centres.

A shoal is a connected component of the graph that joins robots within `CONTACT_RANGE` of each other; a robot
alone is a shoal of one. The largest shoal has the most members, at least two; of several equally large ones
the most compact counts (smallest sum of squared distances to its mean position).
A robot is present when it is said to be and its pose is finite; absent robots take part in nothing.

All arrays have the runs in front, and every compiled function loops over the runs itself: a view of one run's
part costs more than the arithmetic on it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.four import LANES
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel
from cocorosim_ros.study.metrics.memory import Memory

CONTACT_RANGE = 0.5
"""Distance up to which two robots are neighbours [m] (the paper's range of blue light and radio)."""

MEAN, MEDIAN = 0, 1
"""Kinds of centre: the mean position, the median of each coordinate."""

ALL, LARGEST = 0, 1
"""Populations: all present robots, those of the largest shoal."""

MOST_AT_ONCE = 55
"""Numbers whose medians are found in four lanes: the pairs of the paper's eleven robots. Of more, each lane is for
itself.
"""


class Swarms(NamedTuple):
    """What a family's `measure` may read; it may write to `memory.contact`, `memory.lost` and working space only."""

    position: Floats
    """(runs, n, 3) [m; world]."""
    elapsed_ns: Integers
    """(runs,) time since the previous tick [ns], not positive when there is none."""
    memory: Memory
    """The previous tick."""
    members: Flags
    """(2, runs, n) of each population."""
    movers: Flags
    """(2, runs, n) those members of each population that were present at the previous tick, too."""
    heading: Floats
    """(runs, n, 3) unit vector along the bow, horizontal."""
    travel: Floats
    """(runs, n, 3) unit vector of the movement since the previous tick, zero for a robot exactly at rest."""
    squared: Floats
    """(runs, n(n-1)/2) squared distances of the pairs (0,1), (0,2), ... (n-2,n-1) [m^2], +inf if one is
    absent.
    """
    shoal: Integers
    """(runs, n) lowest robot number in the robot's shoal, -1 for absent ones."""
    one_shoal: Flags
    """(runs,) both populations are the same robots."""
    centre: Floats
    """(2, 2, runs, 3) of population and kind, the centre of the members [m; world], NaN of nobody."""
    scratch: Floats
    """(max(n, n(n-1)/2) + 1,) working space for medians."""
    rows: Floats
    """(max(n, MOST_AT_ONCE), 4) working space for medians of four runs."""
    rows_of_robots: Floats
    """(n, 8, 4) working space for numbers of the robots of four runs."""
    runs: Integers
    """(runs + 1,) working space for a list of runs."""


@allocating_kernel
def new_swarms(position: Floats, elapsed_ns: Integers, memory: Memory) -> Swarms:
    """Swarms whose shared work is not filled in yet."""
    runs, robots = position.shape[0], position.shape[1]
    pairs = robots * (robots - 1) // 2
    return Swarms(
        position,
        elapsed_ns,
        memory,
        np.empty((2, runs, robots), np.bool_),
        np.empty((2, runs, robots), np.bool_),
        np.empty((runs, robots, 3)),
        np.empty((runs, robots, 3)),
        np.empty((runs, pairs)),
        np.empty((runs, robots), np.int64),
        np.empty(runs, np.bool_),
        np.empty((2, 2, runs, 3)),
        np.empty(max(robots, pairs) + 1),
        np.empty((max(robots, MOST_AT_ONCE), LANES)),
        np.empty((robots, 8, LANES)),
        np.empty(runs + 1, np.int64),
    )
