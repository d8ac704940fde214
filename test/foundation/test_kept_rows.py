"""Rows of a long run: all are there however many, memory stays the same, and a full disk costs none."""

from __future__ import annotations

import tempfile
import tracemalloc
from io import BytesIO
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation import kept_rows
from cocorosim_ros.foundation.kept_rows import ROWS_IN_MEMORY, KeptRows
from cocorosim_ros.foundation.mapped_table import is_in_file


@pytest.mark.parametrize("count", [0, 1, ROWS_IN_MEMORY, ROWS_IN_MEMORY + 1, 3 * ROWS_IN_MEMORY + 7])
def test_all_rows_are_there(count: int) -> None:
    """In their order, also if they are asked for in between, and of the kind that they were given as."""
    for kind in (np.float64, np.int64):
        kept = KeptRows((2,), kind)
        for number in range(count):
            kept.next_row()[:] = (number, -number)
            assert kept.last()[0] == number
            if number % 700 == 0:
                assert kept.rows().shape == (number + 1, 2)
        assert kept.count == count
        rows = kept.rows()
        assert (type(rows), rows.dtype) == (np.ndarray, kind)
        np.testing.assert_array_equal(rows, np.outer(np.arange(count), (1, -1)))


@pytest.mark.parametrize("count", [0, 1, ROWS_IN_MEMORY, 3 * ROWS_IN_MEMORY + 7])
def test_many_rows_at_once(count: int) -> None:
    """They come back in any order, also of a record of several numbers, and as a copy."""
    kept = KeptRows((), np.dtype([("stamp", np.int64), ("place", np.float64, (2,))]))
    rows = np.zeros(count, kept.copy().dtype)
    rows["stamp"], rows["place"] = np.arange(count), np.outer(np.arange(count), (0.5, -1.0))
    for begin in range(0, count, 700):
        kept.add(rows[begin : begin + 700])
    np.testing.assert_array_equal(kept.copy(), rows)
    places = np.random.default_rng(1).integers(0, max(count, 1), 50 if count else 0)
    np.testing.assert_array_equal(kept.at(places), rows[places])


def test_memory_stays_as_it_is() -> None:
    """A hundred times as many rows as memory holds take no more of it than twice as many."""
    kept = KeptRows((1, 30), np.float64)
    tracemalloc.start()
    try:
        sizes = []
        for blocks in (2, 100):
            while kept.count < blocks * ROWS_IN_MEMORY + 1:
                kept.next_row()[:] = 1.0
            sizes.append(tracemalloc.get_traced_memory()[0])
    finally:
        tracemalloc.stop()
    assert sizes[1] - sizes[0] < 0.1 * ROWS_IN_MEMORY * 30 * 8
    assert kept.rows().sum() == kept.count * 30


@pytest.mark.parametrize("most", [0, 1_000_000])
def test_final_rows_outlast_their_keeper(monkeypatch: pytest.MonkeyPatch, most: int) -> None:
    """Many stay in the file, few are in memory; both are there when all else is gone."""
    monkeypatch.setattr(kept_rows, "_MOST_COPIED", most)
    kept = KeptRows((2,), np.float64)
    kept.add(np.outer(np.arange(3 * ROWS_IN_MEMORY + 7), (1.0, -1.0)))
    final = kept.final()
    del kept
    assert is_in_file(final) == (most == 0)
    np.testing.assert_array_equal(final, np.outer(np.arange(3 * ROWS_IN_MEMORY + 7), (1.0, -1.0)))


class FullDisk:
    """A file that can be read and no longer be written."""

    def __init__(self, file: Any) -> None:
        self._file = file

    def __getattr__(self, name: str) -> Any:
        return getattr(self._file, name)

    def write(self, data: bytes) -> int:
        """As a system without room does."""
        raise OSError(28, "No space left on device")


@pytest.mark.parametrize("blocks_until_full", [0, 2])
def test_no_room_for_the_file(monkeypatch: pytest.MonkeyPatch, blocks_until_full: int) -> None:
    """Memory takes what a full disk does not, from the beginning or later on, and no row is lost."""
    kept = KeptRows((1,), np.float64)
    for number in range(5 * ROWS_IN_MEMORY):
        if number == blocks_until_full * ROWS_IN_MEMORY + 1:
            monkeypatch.setattr(tempfile, "TemporaryFile", lambda **options: FullDisk(BytesIO()))
            if kept._file is not None:
                kept._file = FullDisk(kept._file)  # type: ignore[assignment]
        kept.next_row()[0] = number
    assert (kept._file is None, len(kept._block) > ROWS_IN_MEMORY) == (False, True)
    np.testing.assert_array_equal(kept.rows()[:, 0], np.arange(5 * ROWS_IN_MEMORY))
    np.testing.assert_array_equal(kept.copy()[:, 0], np.arange(5 * ROWS_IN_MEMORY))
