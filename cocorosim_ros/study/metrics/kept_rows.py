"""Rows of numbers of a run that may go on for days: the latest in memory, those before in a file that nobody sees."""

from __future__ import annotations

import tempfile
import weakref
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

ROWS_IN_MEMORY = 1024


class KeptRows:
    """Rows of one shape, added one by one and asked for all together.

    A median needs every value, so none is thrown away; memory stays the same however many there are. The file lies in
    the system's folder for temporary files, has no name on Linux and macOS, and goes with its process. Where there is
    no room for it, memory takes the rows, so that no run ends for its statistics.
    """

    def __init__(self, shape: tuple[int, ...], kind: type[np.float64] | type[np.int64]) -> None:
        """`shape` of one row."""
        self._block: NDArray[Any] = np.empty((ROWS_IN_MEMORY, *shape), kind)
        self._file: IO[bytes] | None = None
        self._filed = 0  # rows that are in the file alone
        self.count = 0

    def next_row(self) -> NDArray[Any]:
        """The place of the next row, to be written into."""
        if self.count - self._filed == len(self._block):
            if self._is_written():
                self._filed = self.count
            else:
                self._block = np.concatenate([self._block, np.empty_like(self._block)])
        self.count += 1
        return self.last()

    def last(self) -> NDArray[Any]:
        """The latest row."""
        row: NDArray[Any] = self._block[self.count - 1 - self._filed]
        return row

    def rows(self) -> NDArray[Any]:
        """(count, *shape) all rows, to be read at once: the next row may change them."""
        latest = self._block[: self.count - self._filed]
        if self._filed == 0:
            return latest
        if self._is_written():
            return self._mapped(self.count)
        return np.concatenate([self._mapped(self._filed), latest])

    def _mapped(self, rows: int) -> NDArray[Any]:
        """So many rows of the file, which the system reads when they are looked at."""
        if self._file is None:
            return self._block[:0]
        return np.asarray(np.memmap(self._file, self._block.dtype, "r+", 0, (rows, *self._block.shape[1:])))

    def _is_written(self) -> bool:
        """Whether the rows in memory could be written behind those in the file."""
        try:
            if self._file is None:
                self._file = tempfile.TemporaryFile(prefix="cocorosim_", buffering=0)
                weakref.finalize(self, self._file.close)
            data = self._block[: self.count - self._filed].tobytes()
            self._file.seek(self._filed * self._block[0].nbytes)
            return self._file.write(data) == len(data)
        except OSError:
            return False
