"""Columns of a long table that lies in a file: copied, and no more of the table stays in memory than was before."""

from __future__ import annotations

import mmap
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ROWS_AT_ONCE = 16_384
_SHARED = ("r", "r+", "w+")  # modes of np.memmap; of "c", what was changed lies in memory alone


def columns_of(table: NDArray[Any], begin: int, end: int) -> NDArray[Any]:
    """(rows, ..., end - begin) a copy of these columns of a table (rows, ..., columns)."""
    found = np.empty((*table.shape[:-1], end - begin), table.dtype)
    mapped = _map_of(table)
    for first in range(0, len(table), _ROWS_AT_ONCE):
        rows = slice(first, first + _ROWS_AT_ONCE)
        found[rows] = table[rows, ..., begin:end]
        if mapped is not None and hasattr(mmap, "MADV_DONTNEED"):
            mapped.madvise(mmap.MADV_DONTNEED)  # read again when looked at
    return found


def is_in_file(table: NDArray[Any]) -> bool:
    """Whether the table lies in a file, which the system reads when it is looked at."""
    return _map_of(table) is not None


def _map_of(table: NDArray[Any]) -> mmap.mmap | None:
    """The map of a file that the table is a part of."""
    owner: Any = table
    while isinstance(owner, np.ndarray):
        held: Any = owner.base
        if isinstance(owner, np.memmap) and owner.mode in _SHARED and isinstance(held, mmap.mmap):
            return held
        owner = held
    return None
