"""Medians of vectors, coordinate by coordinate: exact, and without branches on the values.

What a robot hears is in no order, so that a processor would guess half of the branches of a common sort wrong. Each row
is a vector here, three of its lanes the coordinates, and is only ever compared with another one: the smaller numbers of
both go the one way, the larger ones the other. Which rows of a few are compared is laid down beforehand, for each
number of rows (compiling.sorting), so that they stay in registers; many are inserted one after the other.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, in_fours, lanes
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.sorting import lines_that_sort, ordered
from cocorosim_ros.foundation.compiling.stack import unset_stack_rows
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.state.radio import HEARING_LIMIT

FEW = 12  # rows; as many as eleven robots hear, and a little more


def _middle_of(count: int) -> list[str]:
    """The lines that make `low` and `high` the rows in the middle of so many."""
    return [*lines_that_sort(count), f"low, high = row_{(count - 1) // 2}, row_{count // 2}"]


def _median_of_few() -> list[str]:
    lines = ["low, high = rows[0], rows[0]"]
    for count in range(2, FEW + 1):
        lines += [f"{'el' if count > 2 else ''}if count == {count}:", *(f"    {line}" for line in _middle_of(count))]
    return [*lines, "median[0], median[1], median[2], _ = lanes(0.5 * (low + high))"]


_write_median_of_few = compile_lines(
    "write_median_of_few",
    "rows, count, median",
    _median_of_few(),
    {"ordered": ordered, "lanes": lanes},
    outlined_kernel,
)


@outlined_kernel
def _write_median_of_many(rows: Floats, count: int, median: Floats) -> None:
    columns = in_fours(unset_stack_rows(HEARING_LIMIT, LANES))
    for index in range(count):
        carried = rows[index]
        for place in range(index):
            columns[place], carried = ordered(columns[place], carried)
        columns[index] = carried
    middle = 0.5 * (columns[(count - 1) // 2] + columns[count // 2])
    median[0], median[1], median[2], _ = lanes(middle)


@kernel
def coordinate_median(rows: Floats, count: int, median: Floats) -> None:
    """Write the coordinate-wise median of the first `count` of `rows` (n, LANES) into `median` (3,).

    n is at most HEARING_LIMIT; `median` stays where there is no row.
    """
    if 0 < count <= FEW:
        _write_median_of_few(in_fours(rows), count, median)
    elif count > FEW:
        _write_median_of_many(in_fours(rows), count, median)
