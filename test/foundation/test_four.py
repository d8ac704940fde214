"""Four numbers at once: every lane gets what a float would, to the last bit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.four import (
    LANES,
    chosen,
    everywhere,
    four,
    four_at,
    in_fours,
    put_four_at,
    whole_below,
)
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.shuffled import lanes_after, lanes_before, transposed
from cocorosim_ros.foundation.compiling.stack import stack_like

Floats = NDArray[np.float64]
ODD = (0.0, -0.0, 1.0, -1.5, math.pi, 5e-324, -1e308, 1e-200, 7.25e5, 3e6, -2e17, math.inf, -math.inf, math.nan)


@kernel
def arithmetic(first: Any, second: Any, results: Any) -> None:
    """All that a text for robots may do with two numbers."""
    results[0], results[1] = first[0] + second[0], first[0] - second[0]
    results[2], results[3] = first[0] * second[0], first[0] / second[0]
    results[4], results[5], results[6] = -first[0], abs(first[0]), math.sqrt(abs(first[0]))
    results[7], results[8] = 2.0 * first[0] - 1.0, whole_below(first[0])
    results[9] = chosen(first[0] < second[0], first[0], second[0])
    results[10] = chosen(first[0] >= 0.5, 1.0 + first[0], -second[0])
    results[11], results[12] = sine_cosine(first[0])
    work = stack_like(first, 1)
    work[0] = 3.0
    work[0] += first[0]
    work[0] -= second[0]
    work[0] *= second[0]
    results[13] = work[0]


RESULTS = 14


@kernel
def arithmetic_of_fours(first: Floats, second: Floats, results: Floats) -> None:
    """The same for arrays (1, 4), (1, 4), (RESULTS, 4)."""
    arithmetic(in_fours(first), in_fours(second), in_fours(results))


def test_every_lane_gets_the_bits_of_a_float() -> None:
    """For pairs of numbers of all kinds, among them zeros with a sign, subnormal, infinite and no numbers."""
    generator = np.random.default_rng(1)
    for _ in range(300):
        first, second = (
            np.where(generator.random(LANES) < 0.4, generator.choice(ODD, LANES), generator.normal(0.0, 3.0, LANES))
            for _ in range(2)
        )
        together = np.full((RESULTS, LANES), -7.0)
        arithmetic_of_fours(first[None], second[None], together)
        for lane in range(LANES):
            alone = np.full(RESULTS, -7.0)
            arithmetic(first[lane : lane + 1].copy(), second[lane : lane + 1].copy(), alone)
            numbers = ~np.isnan(alone)
            assert (np.isnan(together[:, lane]) == ~numbers).all()
            assert together[numbers, lane].tobytes() == alone[numbers].tobytes()


@kernel
def below(numbers: Floats, limit: float) -> bool:
    """Whether all of (4,) are below a limit."""
    all_below: bool = everywhere(four(numbers[0], numbers[1], numbers[2], numbers[3]) < limit)
    return all_below


@pytest.mark.parametrize(("greatest", "all_below"), [(4.0, True), (5.0, False), (math.nan, False)])
def test_everywhere_means_all(greatest: float, all_below: bool) -> None:
    """Whatever lane it is that fails."""
    for place in range(LANES):
        numbers = np.array([1.0, 2.0, 3.0, 3.5])
        numbers[place] = greatest
        assert below(numbers, 5.0) is all_below


@kernel
def turn(table: Floats, turned: Floats) -> None:
    """Write a table (4, 6) transposed: four columns as fours (4, 4), each of the other two lane by lane."""
    fours = transposed(four_at(table[0], 1), four_at(table[1], 1), four_at(table[2], 1), four_at(table[3], 1))
    for column in range(LANES):
        put_four_at(turned[1 + column], 0, fours[column])
    for column in (0, 5):
        in_fours(turned)[column] = four(table[0, column], table[1, column], table[2, column], table[3, column])


def test_rows_and_lanes_are_in_order() -> None:
    """What is read, turned and written is the transposed table."""
    table, turned = np.arange(24.0).reshape(4, 6), np.zeros((6, 4))
    turn(table, turned)
    assert np.array_equal(turned, table.T)


@kernel
def shifted(row: Floats, moved: Floats) -> None:
    """Write what begins one place before and one after the middle four of `row` (12,) into `moved` (2, 4)."""
    put_four_at(moved[0], 0, lanes_before(four_at(row, 0), four_at(row, LANES)))
    put_four_at(moved[1], 0, lanes_after(four_at(row, LANES), four_at(row, 2 * LANES)))


def test_fours_between_fours() -> None:
    """Of the numbers 0 to 11 the fours that begin with 3 and with 5."""
    moved = np.zeros((2, LANES))
    shifted(np.arange(12.0), moved)
    assert moved.tolist() == [[3.0, 4.0, 5.0, 6.0], [5.0, 6.0, 7.0, 8.0]]
