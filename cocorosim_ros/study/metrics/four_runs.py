"""Four runs at once, one in each lane (see compiling.four): which ones, and their numbers.

Where fewer than four are left, the last one takes the idle lanes, too: the same numbers are written several times.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.four import four, lanes
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.swarms import ALL, Swarms


class FourRuns(NamedTuple):
    """The run of each lane."""

    first: int
    second: int
    third: int
    fourth: int


class Vectors(NamedTuple):
    """Four vectors at once, by their coordinates."""

    x: Any
    y: Any
    z: Any


@kernel
def list_runs(swarms: Swarms, population: int) -> int:
    """Write into `swarms.runs` in which runs a population has its own values; return how many.

    Of ALL all; of LARGEST those with robots outside of the largest shoal.
    """
    count = 0
    for run in range(swarms.one_shoal.shape[0]):
        swarms.runs[count] = run
        count += population == ALL or not swarms.one_shoal[run]
    return count


@kernel
def four_of(runs: Integers, first: int, count: int) -> FourRuns:
    """Four of the first `count` runs of a list, from place `first` on."""
    last = count - 1
    return FourRuns(runs[first], runs[min(first + 1, last)], runs[min(first + 2, last)], runs[min(first + 3, last)])


@kernel
def in_all(number: float) -> Any:
    """The same number in all lanes."""
    return four(number, number, number, number)


@kernel
def numbers(array: Floats, runs: FourRuns, place: int) -> Any:
    """`array[run, place]` of four runs."""
    a, b, c, d = runs
    return four(array[a, place], array[b, place], array[c, place], array[d, place])


@kernel
def vectors(array: Floats, runs: FourRuns, robot: int) -> Vectors:
    """`array[run, robot]` of four runs, coordinate by coordinate."""
    return Vectors(
        coordinates(array, runs, robot, 0), coordinates(array, runs, robot, 1), coordinates(array, runs, robot, 2)
    )


@kernel
def coordinates(array: Floats, runs: FourRuns, robot: int, axis: int) -> Any:
    """`array[run, robot, axis]` of four runs."""
    a, b, c, d = runs
    return four(array[a, robot, axis], array[b, robot, axis], array[c, robot, axis], array[d, robot, axis])


@kernel
def flags(array: Flags, runs: FourRuns, place: int) -> Any:
    """`array[run, place]` of four runs as 0.0 and 1.0."""
    a, b, c, d = runs
    return four(1.0 * array[a, place], 1.0 * array[b, place], 1.0 * array[c, place], 1.0 * array[d, place])


@kernel
def put(array: Floats, runs: FourRuns, place: int, number: Any) -> None:
    """`array[run, place] = number` of four runs."""
    a, b, c, d = runs
    array[a, place], array[b, place], array[c, place], array[d, place] = lanes(number)


@kernel
def put_coordinate(array: Floats, runs: FourRuns, robot: int, axis: int, number: Any) -> None:
    """`array[run, robot, axis] = number` of four runs."""
    a, b, c, d = runs
    (
        array[a, robot, axis],
        array[b, robot, axis],
        array[c, robot, axis],
        array[d, robot, axis],
    ) = lanes(number)
