"""Rows of numbers of a run that may go on for days: the latest in memory, those before in a file that nobody sees."""

from __future__ import annotations

import tempfile
import weakref
from typing import IO, Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from cocorosim_ros.foundation.arrays import Integers

ROWS_IN_MEMORY = 1024
_MOST_COPIED = 1 << 24  # bytes; an open file each for those beyond is not many files


class KeptRows:
    """Rows of one shape, added one by one or many at once, asked for all together or some of them.

    None is thrown away, as a median needs every value; memory stays the same however many there are. The file lies in
    the system's folder for temporary files, has no name on Linux and macOS, and goes with its process. Where there is
    no room for it, memory takes the rows, so that no run ends for its statistics.
    """

    def __init__(self, shape: tuple[int, ...], kind: DTypeLike) -> None:
        """`shape` of one row, `kind` of its numbers."""
        self._block: NDArray[Any] = np.empty((ROWS_IN_MEMORY, *shape), kind)
        self._file: IO[bytes] | None = None
        self._filed = 0  # rows that are in the file alone
        self.count = 0

    def next_row(self) -> NDArray[Any]:
        """The place of the next row, to be written into."""
        self._make_room()
        self.count += 1
        return self.last()

    def add(self, rows: NDArray[Any]) -> None:
        """Rows (any, *shape) come behind those that are there."""
        taken = 0
        while taken < len(rows):
            self._make_room()
            begin = self.count - self._filed
            part = rows[taken : taken + len(self._block) - begin]
            self._block[begin : begin + len(part)] = part
            self.count += len(part)
            taken += len(part)

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

    def copy(self) -> NDArray[Any]:
        """(count, *shape) all rows in memory of their own."""
        found = np.empty((self.count, *self._block.shape[1:]), self._block.dtype)
        for begin in range(0, self.count, ROWS_IN_MEMORY):
            places = np.arange(begin, min(begin + ROWS_IN_MEMORY, self.count))
            found[places] = self.at(places)
        return found

    def final(self) -> NDArray[Any]:
        """(count, *shape) all rows, to be kept, after which none may be added.

        A few are a copy in memory; many stay in the file, which the system reads where they are looked at.
        """
        if self.count * self._block[0].nbytes > _MOST_COPIED:
            return self.rows()
        return self.copy()

    def at(self, places: Integers) -> NDArray[Any]:
        """(len(places), *shape) copies of the rows at these places, in any order; nothing else is read."""
        if (places[1:] < places[:-1]).any():
            order = np.argsort(places, kind="stable")
            found = np.empty((len(places), *self._block.shape[1:]), self._block.dtype)
            found[order] = self._at_sorted(places[order])
            return found
        return self._at_sorted(places)

    def _at_sorted(self, places: Integers) -> NDArray[Any]:
        """Copies of the rows at places that do not fall."""
        found = np.empty((len(places), *self._block.shape[1:]), self._block.dtype)
        in_file = int(np.searchsorted(places, self._filed))
        found[in_file:] = self._block[places[in_file:] - self._filed]
        ends = [*(np.flatnonzero(np.diff(places[:in_file]) != 1) + 1).tolist(), in_file]
        for begin, end in zip([0, *ends[:-1]], ends, strict=True):
            if self._file is not None and begin < end:
                found[begin:end] = self._read(self._file, int(places[begin]), end - begin)
        return found

    def _read(self, file: IO[bytes], first: int, count: int) -> NDArray[Any]:
        """So many successive rows of the file."""
        size = self._block[0].nbytes
        file.seek(first * size)
        return np.frombuffer(file.read(count * size), self._block.dtype).reshape(count, *self._block.shape[1:])

    def _make_room(self) -> None:
        """See that memory has room for a row."""
        if self.count - self._filed < len(self._block):
            return
        if self._is_written():
            self._filed = self.count
        else:
            self._block = np.concatenate([self._block, np.empty_like(self._block)])

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
