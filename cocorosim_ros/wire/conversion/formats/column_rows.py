"""Rows of columns that are arrays already, as binary files hold them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.wire.conversion.clock import Clock
from cocorosim_ros.wire.conversion.conversion_map import TimeMap
from cocorosim_ros.wire.conversion.rows import ColumnError, Stamps, check_times, time_columns

Arrays = Mapping[str, npt.NDArray[Any]]

_MISSING = ("", "none", "nan", "nat")
_INFINITE = ("inf", "-inf")


class ColumnRows:
    """One table in memory: columns by name, (n,) each; `X[2]` is a column of an array (n, k) called X.

    The number of rows is the length that most columns have; of two such lengths the longer one.
    """

    damage = ""

    def __init__(self, origin: str, columns: Arrays) -> None:
        """Raises CocorosimError if there is no row."""
        self.origin = origin
        self._columns = dict(_single_columns(columns))
        lengths = Counter(len(column) for column in self._columns.values())
        self.count = max(lengths, key=lambda length: (lengths[length], length), default=0)
        if not self.count:
            raise CocorosimError(f"{origin} holds no row of numbers; give a file that has some.")

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of all columns that have a cell in every row."""
        return tuple(name for name, cells in self._columns.items() if len(cells) == self.count)

    def row_name(self, row: int) -> str:
        """The row, counted from 1."""
        return f"row {row + 1}"

    def words(self, column: Entry) -> list[str]:
        """The cells of a column as text."""
        return [_text(cell) for cell in self._column(column).tolist()]

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column; NaN where one is missing. Raises CocorosimError for words."""
        cells = self._column(column)
        if cells.dtype.kind in "biuf":
            return cells.astype(np.float64)
        return np.array([self._number(row, cell, column) for row, cell in enumerate(cells.tolist())])

    def stamps(self, when: TimeMap) -> tuple[Stamps, Flags]:
        """(n,) times [ns] and whether each is known; a row whose time is missing has none."""
        known = np.ones(self.count, dtype=bool)
        if when.step_ns is not None and when.counter is None:
            return check_times([round(row * when.step_ns) for row in range(self.count)], when, self), known
        total = [0] * self.count
        for column, nanoseconds in time_columns(when):
            cells = self._column(column)
            if cells.dtype.kind == "M":
                per_unit = next((unit for timed, unit in when.columns if timed is column), None)
                cells = _time_stamps(cells, per_unit, column)
            missing = _MISSING if when.clock else (*_MISSING, *_INFINITE)
            for row, text in enumerate(map(_text, cells.tolist())):
                if text.lower() in missing:
                    known[row] = False
                    continue
                try:
                    total[row] += nanoseconds(text)
                except ArithmeticError as error:
                    raise self._no_time(row, text, column, when.clock) from error
        return check_times(total, when, self), known

    def _column(self, column: Entry) -> npt.NDArray[Any]:
        names = list(self._columns)
        if isinstance(column.value, int):
            if column.value > len(names):
                raise column.problem(f"has {column.found()}, and {self.origin} has only {len(names)} columns.")
            return self._columns[names[column.value - 1]]
        if column.value not in self._columns:
            known = nearest(str(column.value), names)
            raise ColumnError(str(column.problem(f"has {column.found()}, no column of {self.origin}{known}.")))
        cells = self._columns[column.value]
        if len(cells) != self.count:
            raise column.problem(
                f"has {column.found()}, which holds {len(cells)} numbers in {self.origin}, and its rows are "
                f"{self.count}; name a column of that length."
            )
        return cells

    def _no_time(self, row: int, text: str, column: Entry, clock: Clock | None) -> CocorosimError:
        wanted = f"no time like '{clock.form}'; correct it, or the map's 'form'" if clock else "no number; correct it"
        return CocorosimError(
            f"{self.origin} {self.row_name(row)}, column '{column.value}' has '{text[:40]}', which is {wanted}, or "
            "leave the cell empty (NaN, None)."
        )

    def _number(self, row: int, cell: Any, column: Entry) -> float:
        try:
            return float("nan") if cell is None else float(cell)
        except (TypeError, ValueError) as error:
            raise CocorosimError(
                f"{self.origin} {self.row_name(row)}, column '{column.value}' has '{str(cell)[:40]}', which is no "
                "number; name another column."
            ) from error


def _text(cell: Any) -> str:
    """A cell as text; files of MATLAB and HDF hold theirs as bytes."""
    return (cell.decode("utf-8", "replace") if isinstance(cell, bytes) else str(cell)).strip()


def _single_columns(columns: Arrays) -> Mapping[str, npt.NDArray[Any]]:
    """Columns (n,); arrays of two dimensions as `name[0]`, `name[1]`, and what has more or none left out."""
    found: dict[str, npt.NDArray[Any]] = {}
    for name, array in columns.items():
        if array.ndim == 1:
            found[name] = array
        elif array.ndim == 2 and 1 in array.shape:
            found[name] = array.ravel()
        elif array.ndim == 2:
            found.update({f"{name}[{index}]": array[:, index] for index in range(array.shape[1])})
    return found


def _time_stamps(cells: npt.NDArray[Any], per_unit: Fraction | None, column: Entry) -> npt.NDArray[Any]:
    """(n,) nanoseconds since 1970 of moments in time; a missing one is no number."""
    if per_unit is None:
        way = f"time: {{column: {column.value}, unit: ns}}"
        raise column.problem(f"has {column.found()}, a column of moments in time, which count ns; write '{way}'.")
    if per_unit != 1:
        raise column.problem(f"has {column.found()}, a column of moments in time, which count ns; write 'unit: ns'.")
    counts = cells.astype("datetime64[ns]").astype(np.int64).astype(object)
    counts[np.isnat(cells)] = float("nan")
    return counts
