"""A topic or file with others beside it: to each of its rows the one of another that is nearest in time."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.wire.conversion.conversion_map import TimeMap
from cocorosim_ros.wire.conversion.rows import ColumnError, Rows, Stamps

_NUMBER = re.compile("[1-9][0-9]{0,5}")  # of a column


@dataclass(frozen=True)
class Neighbour:
    """The rows of another topic or file, brought to those of the first one."""

    rows: Rows
    nearest: Integers  # (n,) which of them is nearest to each row
    near: Flags  # (n,) whether it is near enough


@dataclass(frozen=True)
class _FieldEntry(Entry):
    """The column of what stands beside, which sentences show as it stands in the map, with the name before it."""

    whole: str

    def found(self) -> str:
        """The column with the name before it."""
        return f"'{self.whole}'"


class BesideRows:
    """The rows of a topic or file; `name.field` is a field of what stands beside it under that name."""

    def __init__(self, rows: Rows, neighbours: Mapping[str, Neighbour]) -> None:
        self._rows = rows
        self._neighbours = neighbours
        self.origin, self.count, self.damage = rows.origin, rows.count, rows.damage

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of all columns, those beside with what they begin with."""
        beside = (f"{name}.{column}" for name, each in self._neighbours.items() for column in each.rows.columns)
        return (*self._rows.columns, *beside)

    def row_name(self, row: int) -> str:
        """The row of the first one."""
        return self._rows.row_name(row)

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column; NaN where there is none, or none near in time."""
        neighbour, inner = self._of(column)
        rows = neighbour.rows if neighbour else self._rows
        try:
            cells = rows.numbers(inner)
        except ColumnError as error:
            known = nearest(str(column.value), self.columns)
            raise column.problem(f"has {column.found()}, no column of {rows.origin}{known}.") from error
        return np.where(neighbour.near, cells[neighbour.nearest], np.nan) if neighbour else cells

    def words(self, column: Entry) -> list[str]:
        """The cells of a column of the first one."""
        return self._rows.words(column)

    def stamps(self, when: TimeMap) -> tuple[Stamps, Flags]:
        """The times of the first one."""
        return self._rows.stamps(when)

    def _of(self, column: Entry) -> tuple[Neighbour | None, Entry]:
        whole = str(column.value)
        name, dot, field = whole.partition(".")
        if not dot or name not in self._neighbours:
            return None, column
        rows = self._neighbours[name].rows
        if whole in self._rows.columns:
            raise column.problem(
                f"has {column.found()}, a column of {self.origin}, and '{field}' of {rows.origin} beside it; give that "
                "another name in 'beside'."
            )
        number = _NUMBER.fullmatch(field) and field not in rows.columns
        return self._neighbours[name], _FieldEntry(
            int(field) if number else field, column.file, column.line, column.key, whole
        )


def neighbour(own: Stamps, other: Rows, when: TimeMap, within_ns: int) -> Neighbour:
    """The rows of another topic or file that are nearest to (n,) times [ns], if not further away than `within_ns`."""
    stamps, known = other.stamps(when)
    order = np.flatnonzero(known)
    order = order[np.argsort(stamps[order], kind="stable")]
    if not order.size:
        return Neighbour(other, np.zeros(len(own), dtype=np.int64), np.zeros(len(own), dtype=bool))
    sorted_stamps = stamps[order]
    after = np.clip(np.searchsorted(sorted_stamps, own), 0, len(order) - 1)
    before = np.maximum(after - 1, 0)
    chosen = np.where(np.abs(sorted_stamps[before] - own) <= np.abs(sorted_stamps[after] - own), before, after)
    return Neighbour(other, order[chosen], np.abs(sorted_stamps[chosen] - own) <= within_ns)
