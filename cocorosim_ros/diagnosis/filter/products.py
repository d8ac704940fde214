"""Sums of products of slopes over all readings, in one thread and one order, so that every machine finds the same."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array

CHUNK = 1024  # readings in a block, so that a block stays in the processor's cache
LANES = 8


@kernel
def _dot(left: Floats, right: Floats) -> float:
    """Sum of products, in LANES sums beside each other."""
    sums, total = stack_array(8), 0.0
    whole = left.shape[0] - left.shape[0] % LANES
    for begin in range(0, whole, LANES):
        for lane in range(LANES):
            sums[lane] += left[begin + lane] * right[begin + lane]
    for index in range(whole, left.shape[0]):
        total += left[index] * right[index]
    for lane in range(LANES):
        total += sums[lane]
    return total


@kernel
def _is_nothing(values: Floats) -> bool:
    for index in range(values.shape[0]):
        if values[index] != 0.0:
            return False
    return True


@allocating_kernel
def _products(left: Floats, right: Floats, variance: Floats, same: bool) -> Floats:
    """Products of rows (a, m) and (b, m); same: both are one array, so that half of the products are enough."""
    result, weighted = np.zeros((left.shape[0], right.shape[0])), np.empty(CHUNK)
    nothing = np.zeros(right.shape[0], dtype=np.bool_)
    for begin in range(0, variance.shape[0], CHUNK):
        end = min(begin + CHUNK, variance.shape[0])
        for j in range(right.shape[0]):
            nothing[j] = _is_nothing(right[j, begin:end])
        for i in range(left.shape[0]):
            if _is_nothing(left[i, begin:end]):  # slopes of other robots' numbers
                continue
            for index in range(begin, end):
                weighted[index - begin] = left[i, index] / variance[index]
            for j in range(i if same else 0, right.shape[0]):
                if not nothing[j]:
                    result[i, j] += _dot(weighted[: end - begin], right[j, begin:end])
    if same:
        for i in range(result.shape[0]):
            for j in range(i):
                result[i, j] = result[j, i]
    return result


def weighted_products(left: Floats, right: Floats, variance: Floats) -> Floats:
    """Product (a, b) left^T diag(1 / variance) right of left (m, a), right (m, b), variance (m,)."""
    few, many = (left, right) if left.shape[1] <= right.shape[1] else (right, left)
    rows = np.ascontiguousarray(few.T)
    same = left is right
    found: Floats = _products(rows, rows if same else np.ascontiguousarray(many.T), variance, same)
    return found if few is left else found.T
