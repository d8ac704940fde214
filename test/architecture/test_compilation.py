"""What compiled functions may do: working space on the stack, no allocation, the same arithmetic as Python."""

from __future__ import annotations

import numba
import numpy as np
import pytest

from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array


@kernel
def _running_sums(values: np.ndarray, result: np.ndarray) -> None:
    for row in range(values.shape[0]):
        sums = stack_array(2)
        sums[0] += values[row]
        sums[1] += 2.0 * values[row]
        result[row] = sums[0] + sums[1]


def test_stack_arrays_are_zero_each_time() -> None:
    """In a loop, every turn finds zeros: 3 x each value, nothing of the turn before."""
    result = np.empty(5)
    _running_sums(np.arange(5.0), result)
    assert result.tolist() == [0.0, 3.0, 6.0, 9.0, 12.0]


def test_a_kernel_cannot_allocate() -> None:
    """The compiler refuses an array that is made on the way; where allocation is declared it does not."""

    @kernel
    def refused(size: int) -> float:
        return float(np.ones(size).sum())

    @allocating_kernel
    def allowed(size: int) -> float:  # a function of its own, or the cache would give it to the one above
        return float(np.ones(size).sum())

    with pytest.raises(numba.TypingError):
        refused(3)
    assert allowed(3) == 3.0


def test_no_fast_math() -> None:
    """Sums keep their order: 1e16 + 1 - 1e16 is 0 in one order and 1 in another."""

    @kernel
    def ordered(values: np.ndarray) -> float:
        total = 0.0
        for index in range(values.shape[0]):
            total += values[index]
        return total

    assert ordered(np.array([1e16, 1.0, -1e16, 1.0])) == 1.0
