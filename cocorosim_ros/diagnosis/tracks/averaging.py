"""Streams on a grid: readings that fall between two grid points are averaged."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.foundation.arrays import Flags, Floats, Integers


class Taken(NamedTuple):
    """Columns of a timeline, each (m,)."""

    kind: Integers
    stream: Integers
    stamp: Floats
    value: Floats
    share: Floats
    reach: Floats

    def ordered(self, order: Integers) -> Taken:
        """The rows (m,) in another order."""
        return Taken._make(column[order] for column in self)


NOTHING = Taken(np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64), *np.zeros((4, 0)))


class Averaged(NamedTuple):
    """One stream, at most one row for each grid point."""

    stamp: Floats  # (n,) [s]
    value: Floats  # (n, columns), NaN where nothing was read
    share: Floats  # (n, columns) variance over that of a single reading
    reach: Floats  # (n,) [s] within which of the stamp the readings of an average lie evenly

    def of_kind(self, column: int, kind: int, stream: int, inside: Flags) -> Taken:
        """The readings of one column, those that are there and `inside` (n,)."""
        shown = np.isfinite(self.value[:, column]) & inside
        count = int(np.count_nonzero(shown))
        kinds, streams = np.full(count, kind, dtype=np.int64), np.full(count, stream, dtype=np.int64)
        value, share = self.value[shown, column], self.share[shown, column]
        return Taken(kinds, streams, self.stamp[shown], value, share, self.reach[shown])


def joined(parts: Sequence[Taken]) -> Taken:
    """The rows of all parts, one after the other."""
    columns = [np.concatenate(column) for column in zip(NOTHING, *parts, strict=True)]
    return Taken._make(columns)


def averaged_stream(stream: Stream, step: float, begin: float) -> Averaged:
    """A stream with at most one reading for each grid point, NaN where none."""
    if len(stream.time) == 0:
        return Averaged(stream.time, stream.value, np.ones_like(stream.value), stream.time)
    point = np.rint((stream.time - begin) / step).astype(np.int64)
    first = np.flatnonzero(np.concatenate([[True], point[1:] != point[:-1]]))
    count = np.diff(np.append(first, len(point)))
    every = count.astype(np.float64)
    stamp = np.add.reduceat(stream.time, first) / every
    given = np.isfinite(stream.value)
    shown = np.add.reduceat(given.astype(np.float64), first, axis=0)
    shown[shown == 0.0] = np.nan
    value = np.add.reduceat(np.where(given, stream.value, 0.0), first, axis=0) / shown
    variance = np.add.reduceat((stream.time - np.repeat(stamp, count)) ** 2, first)
    return Averaged(stamp, value, 1.0 / shown, np.sqrt(3.0 * variance / every))


def around_point(after: Floats, reach: Floats) -> tuple[Floats, Floats]:
    """Mean distance from 0 and mean sign of moments that lie evenly in `after` +- `reach` [s], all (m,)."""
    astride = np.abs(after) < reach
    width = np.where(astride, reach, 1.0)
    apart = np.where(astride, (after**2 + reach**2) / (2.0 * width), np.abs(after))
    return apart, np.where(astride, after / width, np.sign(after))
