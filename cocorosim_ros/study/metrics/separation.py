"""Separation: how far apart the robots are.

The paper gives "the median separation between AUVs in the shoal over the entire simulation time" and leaves
open which pairs count. The default takes all pairs of robots, as polarisation takes all robots; its run
summary is the median over time of these medians.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.median import middle_of_first
from cocorosim_ros.study.metrics.metric import READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import ALL, LARGEST, Swarms


@kernel
def _median_root(scratch: Floats, count: int) -> float:
    """Median of the square roots of `scratch[:count]`."""
    lower, upper = middle_of_first(scratch, count)
    return float(0.5 * (np.sqrt(lower) + np.sqrt(upper)))


@kernel
def _write_all_pairs(squared: Floats, scratch: Floats, values: Floats, column: int) -> None:
    for run in range(squared.shape[0]):
        count = 0
        for pair in range(squared.shape[1]):
            scratch[count] = squared[run, pair]
            count += squared[run, pair] < np.inf
        values[run, column] = _median_root(scratch, count)


@kernel
def _write_within_shoals(swarms: Swarms, values: Floats, column: int) -> None:
    """The median within all shoals is in values[:, column], that within the largest in the next column."""
    for run in range(values.shape[0]):
        if swarms.one_shoal[run]:
            # All pairs are pairs of the only shoal.
            values[run, column] = values[run, column - 1]
            values[run, column + 1] = values[run, column - 1]
            continue
        pairs = _gather_within_shoals(swarms, ALL, run)
        values[run, column] = _median_root(swarms.scratch, pairs)
        size = 0
        for i in range(swarms.shoal.shape[1]):
            size += swarms.members[LARGEST, run, i]
        if size * (size - 1) // 2 == pairs:
            # Whoever else there is swims alone.
            values[run, column + 1] = values[run, column]
        else:
            pairs = _gather_within_shoals(swarms, LARGEST, run)
            values[run, column + 1] = _median_root(swarms.scratch, pairs)


@kernel
def _gather_within_shoals(swarms: Swarms, population: int, run: int) -> int:
    """The squared distances of the pairs of the same shoal are in `scratch`; return how many."""
    members, shoal, squared, scratch = swarms.members[population], swarms.shoal, swarms.squared, swarms.scratch
    count, pair = 0, 0
    for i in range(shoal.shape[1]):
        for j in range(i + 1, shoal.shape[1]):
            scratch[count] = squared[run, pair]
            count += members[run, i] and shoal[run, i] == shoal[run, j]
            pair += 1
    return count


@kernel
def _write_nearest(
    squared: Floats,
    n: int,
    scratch: Floats,
    values: Floats,
    column: int,
) -> None:
    for run in range(squared.shape[0]):
        for i in range(n):
            scratch[i] = np.inf
        pair = 0
        for i in range(n):
            for j in range(i + 1, n):
                scratch[i] = min(scratch[i], squared[run, pair])
                scratch[j] = min(scratch[j], squared[run, pair])
                pair += 1
        count = 0
        for i in range(n):
            nearest = scratch[i]
            scratch[count] = nearest
            count += nearest < np.inf
        values[run, column] = _median_root(scratch, count)


@kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    _write_all_pairs(swarms.squared, swarms.scratch, values, column)
    _write_within_shoals(swarms, values, column + 1)
    _write_nearest(swarms.squared, swarms.shoal.shape[1], swarms.scratch, values, column + 3)
    return column + 4


def _metric(suffix: str, formula: str, paper: bool = False) -> Metric:
    return Metric(f"separation{suffix}", "m", formula, READ, summary="median", paper=paper)


FAMILY = Family(
    metrics=(
        _metric("", "median distance over all pairs of robots", paper=True),
        _metric("_same_shoal", "median distance over the pairs of robots of the same shoal"),
        _metric("_largest", "median distance over the pairs of robots of the largest shoal"),
        _metric("_nearest", "median over the robots of the distance to their nearest robot"),
    ),
    measure=_measure,
)
