"""Shoal speed: how fast the centre of the robots moves, in three dimensions.

The centre of now and the centre of the previous tick are taken over the same robots (those of now that were
also present then), so that a robot that joins, leaves or is absent does not make the centre jump. The paper
leaves open what the centre is and who belongs to the shoal: the default is the mean of all robots.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.study.metrics.four_runs import list_runs
from cocorosim_ros.study.metrics.metric import READ, Family, Metric
from cocorosim_ros.study.metrics.populations import copy_centres, write_centres
from cocorosim_ros.study.metrics.swarms import ALL, Swarms


@kernel
def _fill_centres_of_movers(swarms: Swarms, population: int, now: Floats, then: Floats) -> None:
    """The centres at this and at the previous tick of the same robots are in now and then (2, runs, 3).

    Of LARGEST only where it is not ALL, whose centres are there already.
    """
    memory, movers = swarms.memory, swarms.movers[population]
    count = _list_others(swarms, population, memory.present, memory.centre, then)
    write_centres(memory.position, movers, count, then, swarms)
    count = _list_others(swarms, population, swarms.members[population], swarms.centre[population], now)
    write_centres(swarms.position, movers, count, now, swarms)


@kernel
def _list_others(swarms: Swarms, population: int, robots: Flags, centre: Floats, target: Floats) -> int:
    """List the runs whose movers are others than `robots`; `centre` is theirs where they are the same, and copied."""
    count, others = list_runs(swarms, population), 0
    for place in range(count):
        run = swarms.runs[place]
        if _same(swarms.movers[population], robots, run):
            copy_centres(centre, run, target)
        else:
            swarms.runs[others] = run
            others += 1
    return others


@kernel
def _same(some: Flags, others: Flags, run: int) -> bool:
    """Whether two groups of a run are the same robots."""
    same = True
    for i in range(some.shape[1]):
        same = same and some[run, i] == others[run, i]
    return same


@kernel
def _write_speed(
    now: Floats,
    then: Floats,
    elapsed_ns: Integers,
    values: Floats,
    column: int,
) -> None:
    for run in range(elapsed_ns.shape[0]):
        x, y, z = now[run, 0] - then[run, 0], now[run, 1] - then[run, 1], now[run, 2] - then[run, 2]
        elapsed = elapsed_ns[run] / 1e9
        values[run, column] = np.sqrt(x * x + y * y + z * z) / elapsed if elapsed > 0.0 else np.nan


@allocating_kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    now, then = np.empty_like(swarms.centre[ALL]), np.empty_like(swarms.centre[ALL])
    for population in range(2):
        _fill_centres_of_movers(swarms, population, now, then)
        for kind in range(2):
            _write_speed(now[kind], then[kind], swarms.elapsed_ns, values, column)
            column += 1
    return column


def _metric(suffix: str, centre: str, members: str, paper: bool = False) -> Metric:
    formula = f"distance that the {centre} of the positions of {members} moved since the previous moment, per time"
    return Metric(f"shoal_speed{suffix}", "m/s", formula, READ, paper=paper, frame_free="median" not in centre)


FAMILY = Family(
    metrics=(
        _metric("", "mean", "all robots", paper=True),
        _metric("_median_centre", "coordinate-wise median", "all robots"),
        _metric("_largest", "mean", "the largest shoal's robots"),
        _metric("_median_centre_largest", "coordinate-wise median", "the largest shoal's robots"),
    ),
    measure=_measure,
)
