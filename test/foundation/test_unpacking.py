"""A row of numbers is unpacked as Python unpacks a sequence, for one robot and for four at once."""

from __future__ import annotations

import numba
import numpy as np
import pytest

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack


@kernel
def _turned_round(row: Floats, shown: Floats) -> None:
    first, second, third = unpack(row, 3)
    shown[0], shown[1], shown[2] = third, second, first


@kernel
def _four_turned_round(rows: Floats, shown: Floats) -> None:
    _turned_round(in_fours(rows), in_fours(shown))


@pytest.mark.parametrize("step", [1, 2])
def test_numbers_come_in_their_order(step: int) -> None:
    """The first three of a longer row, also where they do not lie side by side in memory."""
    row, shown = np.arange(1.0, 11.0)[::step], np.zeros(3)
    _turned_round(row, shown)
    assert shown.tolist() == row[2::-1].tolist()


def test_fours_come_in_their_order() -> None:
    """Each lane for itself."""
    rows, shown = np.arange(12.0).reshape(3, 4) ** 2, np.zeros((3, 4))
    _four_turned_round(rows, shown)
    assert shown.tolist() == rows[::-1].tolist()


def test_a_count_that_is_not_written_out_is_refused() -> None:
    """The compiler has to know how many names there are."""

    @numba.njit
    def unknown(row: Floats, count: int) -> float:
        (first,) = unpack(row, count)
        return first  # type: ignore[no-any-return]

    with pytest.raises(numba.TypingError, match="written out"):
        unknown(np.zeros(3), 1)
