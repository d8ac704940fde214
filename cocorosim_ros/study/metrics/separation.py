"""Separation: how far apart the robots are.

The paper gives "the median separation between AUVs in the shoal over the entire simulation time" and leaves
open which pairs count. The default takes all pairs of robots, as polarisation takes all robots; its run
summary is the median over time of these medians.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, chosen, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.sorting import ordered
from cocorosim_ros.study.metrics.four_runs import FourRuns, flags, four_of, in_all, list_runs, numbers, put
from cocorosim_ros.study.metrics.median import middle_of_first
from cocorosim_ros.study.metrics.median_of_four import middles, no_filling, put_or_leave_out
from cocorosim_ros.study.metrics.metric import READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import ALL, LARGEST, MOST_AT_ONCE, Swarms


@kernel
def _write_pairs(swarms: Swarms, population: int, within: bool, count: int, values: Floats, column: int) -> None:
    """The median over the pairs of a population, or over those in the same shoal, of the first `count` runs listed."""
    if swarms.squared.shape[1] > MOST_AT_ONCE:
        for place in range(count):
            run = swarms.runs[place]
            lower, upper = middle_of_first(swarms.scratch, _gather_pairs(swarms, population, within, run))
            values[run, column] = 0.5 * (math.sqrt(lower) + math.sqrt(upper))
        return
    for first in range(0, count, LANES):
        runs = four_of(swarms.runs, first, count)
        filling = _put_pairs_within(swarms, population, runs) if within else _put_all_pairs(swarms, runs)
        _put_median(swarms, swarms.squared.shape[1], filling, runs, values, column)


@kernel
def _gather_pairs(swarms: Swarms, population: int, within: bool, run: int) -> int:
    """The squared distances of the pairs that count are in `scratch`; return how many."""
    members, shoal, squared, scratch = swarms.members[population], swarms.shoal, swarms.squared, swarms.scratch
    count, pair = 0, 0
    for i in range(shoal.shape[1]):
        for j in range(i + 1, shoal.shape[1]):
            scratch[count] = squared[run, pair]
            together = not within or (members[run, i] and shoal[run, i] == shoal[run, j])
            count += together and squared[run, pair] < np.inf
            pair += 1
    return count


@kernel
def _put_all_pairs(swarms: Swarms, runs: FourRuns) -> Any:
    """The squared distances are in `rows`; return the next filling."""
    rows, filling = in_fours(swarms.rows), no_filling()
    for pair in range(swarms.squared.shape[1]):
        squared = numbers(swarms.squared, runs, pair)
        filling = put_or_leave_out(rows, pair, squared, squared < np.inf, filling)
    return filling


@kernel
def _put_pairs_within(swarms: Swarms, population: int, runs: FourRuns) -> Any:
    """The squared distances of the pairs in the same shoal are in `rows`; return the next filling."""
    rows, shoal, filling, pair = in_fours(swarms.rows), in_fours(swarms.rows_of_robots), no_filling(), 0
    for i in range(swarms.shoal.shape[1]):
        # Who does not count is in a shoal of its own.
        counts = flags(swarms.members[population], runs, i) > 0.0
        shoal[i, 0] = chosen(counts, 1.0 * numbers(swarms.shoal, runs, i), in_all(-1.0 - i))
    for i in range(swarms.shoal.shape[1]):
        for j in range(i + 1, swarms.shoal.shape[1]):
            together = abs(shoal[i, 0] - shoal[j, 0]) < 0.5
            filling = put_or_leave_out(rows, pair, numbers(swarms.squared, runs, pair), together, filling)
            pair += 1
    return filling


@kernel
def _put_median(swarms: Swarms, count: int, filling: Any, runs: FourRuns, values: Floats, column: int) -> None:
    """The medians of the square roots of the first `count` numbers in `rows` are in values[:, column] of four runs."""
    lower, upper = middles(swarms.rows, count, filling, runs, swarms.scratch)
    put(values, runs, column, 0.5 * (math.sqrt(lower) + math.sqrt(upper)))


@kernel
def _put_nearest(swarms: Swarms, runs: FourRuns, values: Floats, column: int) -> None:
    rows, nearest, filling, pair = in_fours(swarms.rows), in_fours(swarms.rows_of_robots), no_filling(), 0
    robots = swarms.shoal.shape[1]
    for i in range(robots):
        nearest[i, 0] = in_all(np.inf)
    for i in range(robots):
        of_this = nearest[i, 0]
        for j in range(i + 1, robots):
            squared = numbers(swarms.squared, runs, pair)
            of_this, nearest[j, 0] = ordered(of_this, squared)[0], ordered(nearest[j, 0], squared)[0]
            pair += 1
        filling = put_or_leave_out(rows, i, of_this, of_this < np.inf, filling)
    _put_median(swarms, robots, filling, runs, values, column)


@kernel
def _list_split(swarms: Swarms, count: int) -> int:
    """Keep those of the first `count` runs listed in which robots outside of the largest shoal have company."""
    shoal, inside, kept = swarms.shoal, swarms.members[LARGEST], 0
    for place in range(count):
        run, company = swarms.runs[place], False
        for i in range(shoal.shape[1]):
            # Of each shoal but the first robot all are known by the first one's number.
            company = company or (shoal[run, i] >= 0 and shoal[run, i] != i and not inside[run, i])
        swarms.runs[kept] = run
        kept += company
    return kept


@kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    count = list_runs(swarms, ALL)
    _write_pairs(swarms, ALL, False, count, values, column)
    for first in range(0, count, LANES):
        _put_nearest(swarms, four_of(swarms.runs, first, count), values, column + 3)
    for run in range(values.shape[0]):
        # Of the only shoal all pairs are its pairs.
        values[run, column + 1] = values[run, column]
    count = list_runs(swarms, LARGEST)
    _write_pairs(swarms, ALL, True, count, values, column + 1)
    for run in range(values.shape[0]):
        values[run, column + 2] = values[run, column + 1]
    _write_pairs(swarms, LARGEST, True, _list_split(swarms, count), values, column + 2)
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
