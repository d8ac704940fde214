"""Columns of a table in a file: the same numbers, and the table does not come into memory for them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.mapped_table import columns_of, is_in_file

ROWS, COLUMNS = 40_000, 30


@pytest.fixture
def table(tmp_path: Path) -> np.memmap:
    """Numbers in a file."""
    made: np.memmap = np.memmap(tmp_path / "table", np.float64, "w+", 0, (ROWS, 1, COLUMNS))
    made[:] = np.arange(ROWS * COLUMNS, dtype=float).reshape(made.shape)
    return made


def test_columns_are_those_of_the_table(table: np.memmap) -> None:
    """Of a file, of a part of it, and of memory; they are copies."""
    within = np.asarray(table)[:, 0]
    for whole in (table, within, np.array(within)):
        found = columns_of(whole, 3, 5)
        np.testing.assert_array_equal(found, np.array(whole)[..., 3:5])
        assert found.flags.c_contiguous and found.flags.writeable and not np.shares_memory(found, whole)


def test_it_is_known_what_lies_in_a_file(table: np.memmap, tmp_path: Path) -> None:
    """Also of a part. What was changed in memory alone is not let go."""
    assert is_in_file(table) and is_in_file(np.asarray(table)[5:, 0])
    assert not is_in_file(np.array(table))
    table.flush()
    private = np.memmap(tmp_path / "table", np.float64, "c", 0, (ROWS, COLUMNS))
    private[:] = -1.0
    assert not is_in_file(private)
    assert (columns_of(private, 0, 1) == -1.0).all() and (private == -1.0).all()


@pytest.mark.skipif(not Path("/proc/self/smaps").exists(), reason="the system does not tell what it keeps of a file")
def test_the_table_does_not_stay_in_memory(table: np.memmap, tmp_path: Path) -> None:
    """Of 10 MB none."""
    assert _kept_of(tmp_path) > 9.0
    columns_of(np.asarray(table), 3, 4)
    assert _kept_of(tmp_path) < 1.0


def _kept_of(folder: Path) -> float:
    """How much of the files in a folder is in the memory of this process [MB]."""
    maps = Path("/proc/self/smaps").read_text().split("\nVmFlags")
    return sum(int(each.split("\nRss:")[1].split()[0]) / 1024 for each in maps if str(folder) in each)
