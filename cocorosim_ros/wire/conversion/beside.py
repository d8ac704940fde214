"""A topic or file with others beside it: to each of its rows the one of another that is nearest in time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.conversion_map import TimeMap
from cocorosim_ros.wire.conversion.rows import Rows, Stamps


@dataclass(frozen=True)
class Neighbour:
    """The rows of another topic or file, brought to those of the first one."""

    rows: Rows
    nearest: Integers  # (n,) which of them is nearest to each row
    near: Flags  # (n,) whether it is near enough


class BesideRows:
    """The rows of a topic or file; `name.field` is a field of what stands beside it under that name."""

    def __init__(self, rows: Rows, neighbours: Mapping[str, Neighbour]) -> None:
        self._rows = rows
        self._neighbours = neighbours
        self.origin, self.count, self.damage = rows.origin, rows.count, rows.damage

    def row_name(self, row: int) -> str:
        """The row of the first one."""
        return self._rows.row_name(row)

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column; NaN where there is none, or none near in time."""
        neighbour, inner = self._of(column)
        if neighbour is None:
            return self._rows.numbers(column)
        return np.where(neighbour.near, neighbour.rows.numbers(inner)[neighbour.nearest], np.nan)

    def words(self, column: Entry) -> list[str]:
        """The cells of a column of the first one."""
        return self._rows.words(column)

    def stamps(self, when: TimeMap) -> tuple[Stamps, Flags]:
        """The times of the first one."""
        return self._rows.stamps(when)

    def _of(self, column: Entry) -> tuple[Neighbour | None, Entry]:
        name, dot, field = str(column.value).partition(".")
        if not dot or name not in self._neighbours:
            return None, column
        return self._neighbours[name], replace(column, value=field)


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
