"""Medians of four runs at once, one in each lane (see compiling.four): exact, and without branches on the numbers.

Each run may have its own numbers left out. They become +inf and -inf in turn, and so do places that are left over: what
is in the middle of a lane stays there. The same comparisons then sort all lanes, and the same two rows end up in the
middle of all.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import chosen, four, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.sorting import lines_that_sort, ordered
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.study.metrics.four_runs import FourRuns, in_all
from cocorosim_ros.study.metrics.median import middle_of_first
from cocorosim_ros.study.metrics.swarms import MOST_AT_ONCE

# Of each the comparisons are written out: eleven robots, the pairs of eight and of eleven.
_SIZES = (11, 28, MOST_AT_ONCE)


def _leave_middle(size: int) -> list[str]:
    lower, upper = (size - 2) // 2, size // 2
    return [*lines_that_sort(size), f"rows[{lower}], rows[{upper}] = row_{lower}, row_{upper}"]


_leave_middle_of_11, _leave_middle_of_28, _leave_middle_of_55 = (
    compile_lines(f"leave_middle_of_{size}", "rows", _leave_middle(size), {"ordered": ordered}, outlined_kernel)
    for size in _SIZES
)


@kernel
def no_filling() -> Any:
    """What `put_or_leave_out` is first given as `filling`."""
    filling = in_all(np.inf)
    return filling


@kernel
def put_or_leave_out(rows: Any, place: int, number: Any, counts: Any, filling: Any) -> Any:
    """Put four numbers into `rows[place]`, `filling` where the condition `counts` does not hold; return the next one.

    rows: (n,) fours, of which those before `place` have been put.
    """
    rows[place] = chosen(counts, number, filling)
    following = chosen(counts, filling, -filling)
    return following


@kernel
def middles(rows: Floats, count: int, filling: Any, runs: FourRuns, scratch: Floats) -> tuple[Any, Any]:
    """The two middle numbers of each of four runs' `rows[:count]`, twice the same for an odd number; NaN where is none.

    rows: (MOST_AT_ONCE or more, 4), `count` of which were put by `put_or_leave_out` with `filling` as its last result;
    they are reordered; scratch: (count + 1,) working space.
    """
    if count > MOST_AT_ONCE:
        found: tuple[Any, Any] = _middles_one_by_one(rows, count, runs, scratch)
        return found
    fours = in_fours(rows)
    size = _SIZES[0] if count <= _SIZES[0] else _SIZES[1] if count <= _SIZES[1] else _SIZES[2]
    for place in range(count, size):
        fours[place] = filling
        filling = -filling
    _leave_middle_of(fours, size)
    lower, upper = fours[(size - 2) // 2], fours[size // 2]
    # An even number of places was left out where the next filling is +inf again.
    even = filling > 0.0
    if size % 2 == 0:
        upper = chosen(even, upper, lower)
    else:
        lower = chosen(even, upper, lower)
    some = abs(lower) < np.inf
    return chosen(some, lower, in_all(np.nan)), upper


@kernel
def _leave_middle_of(rows: Any, size: int) -> None:
    """Put the two middle ones of the first `size` of `rows`, one of `_SIZES`, into their places."""
    if size == _SIZES[0]:
        _leave_middle_of_11(rows)
    elif size == _SIZES[1]:
        _leave_middle_of_28(rows)
    else:
        _leave_middle_of_55(rows)


@kernel
def _middles_one_by_one(rows: Floats, count: int, runs: FourRuns, scratch: Floats) -> tuple[Any, Any]:
    first = _middle_of_lane(rows, 0, count, scratch)
    # Idle lanes have the run of the lane before.
    second = first if runs.second == runs.first else _middle_of_lane(rows, 1, count, scratch)
    third = second if runs.third == runs.second else _middle_of_lane(rows, 2, count, scratch)
    fourth = third if runs.fourth == runs.third else _middle_of_lane(rows, 3, count, scratch)
    return four(first[0], second[0], third[0], fourth[0]), four(first[1], second[1], third[1], fourth[1])


@outlined_kernel
def _middle_of_lane(rows: Floats, lane: int, count: int, scratch: Floats) -> tuple[float, float]:
    found = 0
    for place in range(count):
        scratch[found] = rows[place, lane]
        found += abs(rows[place, lane]) < np.inf
    lower, upper = middle_of_first(scratch, found)
    return lower, upper
