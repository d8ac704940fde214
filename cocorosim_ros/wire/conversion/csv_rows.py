"""The rows of a CSV file: cells as text, numbers and exact times from them."""

from __future__ import annotations

import codecs
import csv
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.counted import counted, either
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.wire.bags.file_kinds import HEAD
from cocorosim_ros.wire.conversion.clock import Clock
from cocorosim_ros.wire.conversion.conversion_map import CsvLayout, TimeMap
from cocorosim_ros.wire.conversion.rows import ColumnError, Stamps, check_times, time_columns

_COMMAS = (
    "if they are decimals with commas, which commas between cells cannot be told from, write the file again with "
    "points or with another separator, else correct the line"
)
_SEPARATORS = "correct the line, or 'separator' in the map's layout"


class CsvRows:
    """One CSV file in memory. Rows that end early have empty cells at their end, and `damage` says how many."""

    def __init__(self, path: Path, origin: str, layout: CsvLayout) -> None:
        """Raises CocorosimError if the file is unreadable, not UTF-8 or holds no row."""
        self.origin = origin
        self._layout = layout
        lines = _lines(path, origin, layout)
        self._header = [name.strip() for name in next(lines, (0, []))[1]] if layout.header else []
        found = list(lines)
        self._line = [number for number, _ in found]
        self._cells = [cells for _, cells in found]
        self.count = len(found)
        if not found:
            raise CocorosimError(f"{origin} holds no row of numbers; give a file that has some.")
        self._width = len(self._header) or max(len(cells) for cells in self._cells)
        self._refuse_longer_rows()
        short = sum(len(cells) < self._width for cells in self._cells)
        early = f"{counted(short, 'row')} {either(short, 'ends early; its', 'end early; their')} last cells"
        self.damage = f"{origin}: {early} count as missing." if short else ""

    @property
    def columns(self) -> tuple[str, ...]:
        """The names in the header."""
        return tuple(self._header)

    def words(self, column: Entry) -> list[str]:
        """The cells of a column as they stand there, empty where a row ends before it."""
        index = self._index(column)
        return [cells[index].strip() if index < len(cells) else "" for cells in self._cells]

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column; NaN where one is missing. Raises CocorosimError for words."""
        texts = self.words(column)
        if self._layout.decimal == ",":
            texts = [text.replace(",", ".") for text in texts]
        try:
            return np.array([float(text) for text in texts])
        except ValueError:
            return np.array([self._number(row, text, column) for row, text in enumerate(texts)])

    def stamps(self, when: TimeMap) -> tuple[Stamps, Flags]:
        """(n,) times [ns] and whether each is known; a row whose time is missing has none."""
        if when.step_ns is not None and when.counter is None:
            times = [round(row * when.step_ns) for row in range(self.count)]
            return check_times(times, when, self), np.ones(self.count, dtype=bool)
        total = [0] * self.count
        known = np.ones(self.count, dtype=bool)
        for column, nanoseconds in time_columns(when, self._layout.decimal):
            for row, text in enumerate(self.words(column)):
                if text.lower() in self._layout.missing:
                    known[row] = False
                    continue
                try:
                    total[row] += nanoseconds(text)
                except ArithmeticError as error:
                    raise self._no_number(row, text, column, when.clock) from error
        return check_times(total, when, self), known

    def row_name(self, row: int) -> str:
        """The line of a row."""
        return f"line {self._line[row]}"

    def _refuse_longer_rows(self) -> None:
        """Raise CocorosimError for a row with more cells than there are columns, which are not where they belong.

        Empty cells beyond the last column are nothing: many programs end every line with a separator.
        """
        for line, cells in zip(self._line, self._cells, strict=True):
            if len(cells) > self._width and any(cell.strip() for cell in cells[self._width :]):
                comma = self._layout.separator == ","
                raise CocorosimError(
                    f"{self.origin} line {line} has {len(cells)} cells and its header {self._width}, so that none can "
                    f"be told from its neighbours; {_COMMAS if comma else _SEPARATORS}."
                )

    def _index(self, column: Entry) -> int:
        """Where a column stands, from 0."""
        if isinstance(column.value, int):
            if column.value > self._width:
                raise column.problem(f"has {column.found()}, and {self.origin} has only {self._width} columns.")
            return column.value - 1
        if not self._header:
            raise column.problem(f"has {column.found()}, and {self.origin} has no header; give the column's number.")
        places = [index for index, name in enumerate(self._header) if name == column.value]
        if not places:
            known = nearest(column.value, self._header)
            raise ColumnError(str(column.problem(f"has {column.found()}, no column of {self.origin}{known}.")))
        if len(places) > 1:
            raise column.problem(f"has {column.found()}, the name of several columns of {self.origin}; give a number.")
        return places[0]

    def _number(self, row: int, text: str, column: Entry) -> float:
        if text.lower() in self._layout.missing:
            return float("nan")
        try:
            return float(text)
        except ValueError as error:
            raise self._no_number(row, text, column) from error

    def _no_number(self, row: int, text: str, column: Entry, clock: Clock | None = None) -> CocorosimError:
        wanted = f"no time like '{clock.form}'" if clock else "no number"
        or_form = ", or the map's 'form'" if clock else ""
        return CocorosimError(
            f"{self.origin} line {self._line[row]}, column '{column.value}' has '{text[:40]}', which is {wanted}; "
            f"correct it{or_form}, or add it to 'missing' in the map's layout."
        )


def refuse_utf16(head: bytes, origin: str) -> None:
    """Raise CocorosimError for a file that begins as text of UTF-16 does, as some programs of Windows write it."""
    marked = head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    every_other = len(head) > 1 and not (any(head[1::2]) and any(head[::2]))
    if marked or every_other:
        raise CocorosimError(f"{origin} is UTF-16 text; save it as UTF-8.")


def _cells(line: str, separator: str) -> list[str]:
    return line.split() if separator == " " else next(csv.reader([line.rstrip("\r\n")], delimiter=separator))


def _lines(path: Path, origin: str, layout: CsvLayout) -> Iterator[tuple[int, list[str]]]:
    """Line number and cells of every line that is neither empty nor a comment."""
    try:
        with path.open("rb") as binary:
            refuse_utf16(binary.read(HEAD), origin)
        encoding = "utf-8-sig" if layout.encoding == "utf-8" else layout.encoding
        with path.open(encoding=encoding, newline="") as file:
            numbered = enumerate(file, start=1)
            for number, line in numbered:
                bare = line.strip()
                if number <= layout.skip or not bare or (layout.comment and bare.startswith(layout.comment)):
                    continue
                yield number, _cells(line, layout.separator)
    except UnicodeDecodeError as error:
        raise CocorosimError(
            f"{origin} is not UTF-8 text; save it as UTF-8, or say 'encoding: latin-1' in the map's layout."
        ) from error
    except csv.Error as error:
        raise CocorosimError(f"{origin} line {number} is not CSV: {error}; correct it.") from error
    except OSError as error:
        raise CocorosimError(f"{origin} cannot be read: {error.strerror}; check its name and permissions.") from error
