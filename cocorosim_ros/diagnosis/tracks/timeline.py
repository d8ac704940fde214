"""The timeline of a track: the readings of a robot, and the grid point that each belongs to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from cocorosim_ros.diagnosis.criteria.filter import FILTER
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.filter.layout import ANGLES, KIND_NAMES, KINDS_OF_STREAM, UPRIGHT
from cocorosim_ros.diagnosis.filter.records import Readings
from cocorosim_ros.diagnosis.tracks.averaging import Taken, around_point, averaged_stream, joined
from cocorosim_ros.diagnosis.tracks.columns import TIMING
from cocorosim_ros.diagnosis.tracks.grid import grid_until
from cocorosim_ros.diagnosis.tracks.last_of_kind import last_of_kind
from cocorosim_ros.diagnosis.tracks.lately import Lately
from cocorosim_ros.diagnosis.tracks.lateness import clocks_of, common_lateness
from cocorosim_ros.foundation.arrays import Flags, Floats, Integers


@dataclass(frozen=True)
class Timing:
    """Errors of stamps by stream: latency [s], by which it is late, and skew [s/s], by which its clock gains."""

    latency: Mapping[str, float] = field(default_factory=dict)
    skew: Mapping[str, float] = field(default_factory=dict)


RIGHT = Timing()


def timing_of(row: Floats) -> Timing:
    """Errors of stamps that a row of numbers (columns,) holds."""
    latency, skew = row[TIMING].reshape(2, len(KINDS_OF_STREAM)).tolist()
    return Timing(dict(zip(KINDS_OF_STREAM, latency, strict=True)), dict(zip(KINDS_OF_STREAM, skew, strict=True)))


class Timeline:
    """All readings of one robot in one recording, averaged where several are nearest to one grid point.

    Readings stand in the order in which the filter takes them if all stamps are right. Each column is (m,):
    kind: codes of filter.layout; stream: numbers in `stream_names`; stamp [s]; value: SI units; share: variance as a
    share of that of a single reading; reach [s]: the readings of an average lie evenly in stamp +- reach.
    clocks: names of the streams whose common lateness the commands have in place of the readings; None: all of the log.
    """

    def __init__(
        self, log: RobotLog, step: float, begin: float, end: float, clocks: Sequence[str] | None = None
    ) -> None:
        self.grid = grid_until(begin, step, end)
        self._clocks = clocks_of(log) if clocks is None else clocks
        self.stream_names = [name for name in KINDS_OF_STREAM if name in log.streams]
        self._log = log
        self._lately: Lately[Readings] = Lately()
        taken = []
        for number, name in enumerate(self.stream_names):
            averaged = averaged_stream(log.streams[name], step, begin)
            inside = (averaged.stamp >= begin) & (averaged.stamp <= end)
            for column, kind in enumerate(KINDS_OF_STREAM[name]):
                taken.append(averaged.of_kind(column, kind, number, inside))
        self._put(joined(taken))
        self._put(self._taken.ordered(self.readings().origin))

    def _put(self, taken: Taken) -> None:
        self._taken = taken
        self.kind, self.stream, self.stamp, self.value, self.share, self.reach = taken

    @cached_property
    def is_angle(self) -> Flags:
        """Flags (m,) of the readings that are angles."""
        return np.isin(self.kind, ANGLES)

    @cached_property
    def is_upright(self) -> Flags:
        """Flags (m,) of the readings of the vertical block."""
        return np.isin(self.kind, UPRIGHT)

    def parts(self, count: int) -> Integers:
        """Number of the part of each reading (m,), of `count` parts of equal length by stamp."""
        share = (self.stamp - self.grid.begin) / (self.grid.step * self.grid.points)
        return np.minimum((share * count).astype(np.int64), count - 1)

    def sees(self, *names: str) -> bool:
        """Tell whether there are readings of any of these kinds, given by name."""
        return not self.kinds.isdisjoint(names)

    @cached_property
    def kinds(self) -> frozenset[str]:
        """Names of the kinds of which there are readings."""
        return frozenset(KIND_NAMES[code] for code in np.unique(self.kind))

    def between(self, first: int, points: int) -> Timeline:
        """Make a timeline of `points` grid points of this one, from grid point `first` on."""
        begin, step, _ = self.grid
        start = begin + first * step
        return Timeline(self._log, step, start, start + step * (points - 1), self._clocks)

    def without_stream(self, name: str) -> Timeline:
        """Make a timeline on the same grid without the readings of a stream."""
        streams = {other: stream for other, stream in self._log.streams.items() if other != name}
        begin, step, points = self.grid
        return Timeline(replace(self._log, streams=streams), step, begin, begin + step * (points - 1), self._clocks)

    def under(self, row: Floats) -> Readings:
        """Readings on the grid, stamps corrected by the errors that a row of numbers (columns,) holds."""
        return self._lately.once(row[TIMING].tobytes(), lambda: self.readings(self.timing_under(row)))

    def timing_under(self, row: Floats) -> Timing:
        """Errors of stamps that a row of numbers (columns,) holds, without what all streams are late by."""
        timing, common = timing_of(row), common_lateness(row, self._clocks)
        return replace(timing, latency={name: late - common for name, late in timing.latency.items()})

    def readings(self, timing: Timing = RIGHT) -> Readings:
        """Readings by grid point, at the moments when they were true if stamps are off by `timing`.

        Such a moment is (stamp - latency) / (1 + skew).
        """
        begin, step, points = self.grid
        moment = self.stamp.copy()
        for number, name in enumerate(self.stream_names):
            chosen = self.stream == number
            skew, latency = timing.skew.get(name, 0.0), timing.latency.get(name, 0.0)
            if skew != 0.0 or latency != 0.0:
                moment[chosen] = (moment[chosen] - latency) / (1.0 + skew)
        point = np.clip(np.rint((moment - begin) / step), 0, points - 1).astype(np.int64)
        after = moment - begin - point * step
        order = np.lexsort((self.kind, moment, point))
        apart, side = around_point(after, self.reach)
        before, gap = last_of_kind(self.kind[order], moment[order], FILTER.near * step)
        return Readings(
            step,
            begin,
            np.searchsorted(point[order], np.arange(points + 1)).astype(np.int64),
            self.kind[order],
            after[order],
            apart[order],
            side[order],
            self.stamp[order],
            self.value[order],
            self.share[order],
            order.astype(np.int64),
            before,
            gap,
        )
