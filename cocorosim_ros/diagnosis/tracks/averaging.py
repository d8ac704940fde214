"""Averages of streams: readings that are nearest to one and the same grid point become one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import Stream
from cocorosim_ros.foundation.arrays import Flags, Floats, Integers


class Taken(NamedTuple):
    """Columns of a timeline, each (m,); `Timeline` says what they hold."""

    kind: Integers
    stream: Integers
    stamp: Floats
    value: Floats
    share: Floats
    reach: Floats

    def ordered(self, order: Integers) -> Taken:
        """Put the rows into the order of their numbers `order` (m,)."""
        return Taken._make(column[order] for column in self)


NOTHING = Taken(np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64), *np.zeros((4, 0)))


class Averaged(NamedTuple):
    """One stream with at most one row for each grid point."""

    stamp: Floats  # (n,) [s]
    value: Floats  # (n, columns), NaN where nothing was read
    share: Floats  # (n, columns) variance as a share of that of a single reading
    reach: Floats  # (n,) [s] the readings of an average lie evenly between stamp - reach and stamp + reach

    def of_kind(self, column: int, kind: int, stream: int, inside: Flags) -> Taken:
        """Take the readings of one column that are there and have the flag `inside` (n,), under these codes."""
        shown = np.isfinite(self.value[:, column]) & inside
        count = int(np.count_nonzero(shown))
        kinds, streams = np.full(count, kind, dtype=np.int64), np.full(count, stream, dtype=np.int64)
        value, share = self.value[shown, column], self.share[shown, column]
        return Taken(kinds, streams, self.stamp[shown], value, share, self.reach[shown])


def joined(parts: Sequence[Taken]) -> Taken:
    """Join rows, one part after the other."""
    columns = [np.concatenate(column) for column in zip(NOTHING, *parts, strict=True)]
    return Taken._make(columns)


def averaged_stream(stream: Stream, step: float, begin: float) -> Averaged:
    """Average the readings of a stream that are nearest to one grid point, NaN left out.

    The reach of an average is sqrt(3) standard deviations of its stamps, as that of moments that lie evenly is.
    step, begin [s]: distance of grid points, and the time of the first.
    """
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
    """Mean distance from 0 [s] and mean sign of moments that lie evenly in `after` +- `reach` [s], all (m,)."""
    astride = np.abs(after) < reach
    width = np.where(astride, reach, 1.0)
    apart = np.where(astride, (after**2 + reach**2) / (2.0 * width), np.abs(after))
    return apart, np.where(astride, after / width, np.sign(after))
