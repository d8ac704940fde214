"""Medians inside compiled code: exact, without allocation, the same on every call.

Both algorithms move values without branching on them: on values in no order, as distances are, a processor
would guess half of the branches wrong.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel

_SHORT = 16


@kernel
def middle_of_first(values: Floats, count: int) -> tuple[float, float]:
    """The two middle values of `values[:count]` (twice the same for an odd count); NaN when count is 0.

    `values` is reordered; no NaN may be among them. The median is the mean of the two.
    """
    if count == 0:
        return np.nan, np.nan
    middle = count // 2
    upper = _select(values, count, middle)
    if count % 2 == 1:
        return upper, upper
    lower = values[0]
    for i in range(1, middle):
        lower = max(lower, values[i])
    return lower, upper


@kernel
def median_of_first(values: Floats, count: int) -> float:
    """Median of `values[:count]`, which are reordered; NaN when count is 0; no NaN may be among them."""
    lower, upper = middle_of_first(values, count)
    return float(0.5 * (lower + upper))


@kernel
def _select(values: Floats, count: int, rank: int) -> float:
    """Quickselect: the value of that rank, with nothing larger to its left."""
    low, high = 0, count
    while high - low > _SHORT:
        pivot = _middle_of_three(values[low], values[(low + high) // 2], values[high - 1])
        larger = _smaller_first(values, low, high, pivot)
        if rank < larger:
            high = larger
            continue
        # The pivot and its equals must be taken out together, or many of them would take quadratic time.
        low = _equal_first(values, larger, high, pivot)
        if rank < low:
            return float(pivot)
    _sort(values, low, high)
    return float(values[rank])


@kernel
def _middle_of_three(a: float, b: float, c: float) -> float:
    return max(min(a, b), min(max(a, b), c))


@kernel
def _smaller_first(values: Floats, low: int, high: int, pivot: float) -> int:
    """Move the values below the pivot to the front of values[low:high]; return where others start."""
    start = low
    for i in range(low, high):
        value = values[i]
        values[i] = values[start]
        values[start] = value
        start += value < pivot
    return start


@kernel
def _equal_first(values: Floats, low: int, high: int, pivot: float) -> int:
    """Move the values equal to the pivot to the front of values[low:high]; return where others start."""
    start = low
    for i in range(low, high):
        value = values[i]
        values[i] = values[start]
        values[start] = value
        start += value == pivot
    return start


@kernel
def _sort(values: Floats, low: int, high: int) -> None:
    for i in range(low + 1, high):
        carried = values[i]
        for j in range(low, i):
            here = values[j]
            values[j] = min(here, carried)
            carried = max(here, carried)
        values[i] = carried
