"""Sums in registers beside the loops over `add_four` whose place they take: the same bits."""

from __future__ import annotations

from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.filter.row_sums import set_sum_of_rows, take_off_products
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import add_four

SIZE = 12


@kernel
def in_registers(factors: Any, source: Any, target: Any, shrunk: Any) -> None:
    """Fours 4 to 7 of the second row, of rows 6 to 11 of the source; then the product of two rows taken off."""
    set_sum_of_rows(target, np.uint64(16), factors, np.uint64(6), source, np.uint64(6 * 12 + 4), 12, 6)
    take_off_products(shrunk, factors, source, 12)


@kernel
def in_loops(factors: Any, source: Any, target: Any, shrunk: Any) -> None:
    """The same, number by number in memory."""
    for row in range(6, 12):
        add_four(target, np.uint64(16), source, np.uint64(row * 12 + 4), factors[row])
    for row in range(12):
        for column in range(0, 12, 4):
            add_four(shrunk, np.uint64(row * 12 + column), source, np.uint64(column), -factors[row])


def test_sums_in_registers_have_the_bits_of_loops() -> None:
    """Of numbers of all sizes, where the order of a sum matters."""
    rng = np.random.default_rng(5)
    factors = rng.standard_normal(SIZE) * 10.0 ** rng.integers(-8, 8, SIZE)
    source, before = rng.standard_normal((2, SIZE * SIZE)) * 10.0 ** rng.integers(-8, 8, (2, SIZE * SIZE))
    found = []
    for way in (in_registers, in_loops):
        target, shrunk = np.zeros(SIZE * SIZE), before.copy()
        way(factors, source, target, shrunk)
        found.append((target, shrunk))
    np.testing.assert_array_equal(found[0][0], found[1][0])
    np.testing.assert_array_equal(found[0][1], found[1][1])
    assert found[0][0].any() and not np.array_equal(found[0][1], before)
