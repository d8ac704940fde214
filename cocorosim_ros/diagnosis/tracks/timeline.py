"""A robot's recording on the grid of the filter: which readings belong to which grid point."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM
from cocorosim_ros.diagnosis.filter.records import Readings
from cocorosim_ros.foundation.arrays import Floats

LONGEST_STEP = 0.1  # s
YAW_ERROR, PLACE_ERROR = 0.005, 0.001  # rad, m: what a step under full acceleration may miss by


def grid_step(acceleration: float, yaw_acceleration: float) -> float:
    """Step [s] of the filter for a vehicle with these greatest accelerations [m/s^2, rad/s^2], a multiple of 10 ms."""
    step = LONGEST_STEP
    if acceleration > 0.0:
        step = min(step, math.sqrt(8.0 * PLACE_ERROR / acceleration))
    if yaw_acceleration > 0.0:
        step = min(step, math.sqrt(8.0 * YAW_ERROR / yaw_acceleration))
    return max(0.01, math.floor(step * 100.0 + 1e-9) / 100.0)


def grid_begin(command_time: Floats, step: float, begin: float) -> float:
    """Where a grid of this step begins, at most a step before `begin` [s], so that commands change at grid points.

    Between grid points the filter knows only the mean of what acts.
    """
    if len(command_time) == 0:
        return begin
    turns = np.exp(2j * np.pi * (command_time - begin) / step)
    phase = float(np.angle(turns.mean()) / (2.0 * np.pi)) % 1.0
    return begin - (1.0 - phase) * step if phase > 0.0 else begin


@dataclass(frozen=True)
class Timing:
    """How the stamps of streams are off: by stream, seconds late, and seconds gained per second."""

    latency: Mapping[str, float] = field(default_factory=dict)
    skew: Mapping[str, float] = field(default_factory=dict)


RIGHT = Timing()


class TrackReadings:
    """All readings of one robot in one recording, averaged where several fall between two grid points.

    They stand in the order in which the filter takes them if all stamps are right.
    """

    def __init__(self, log: RobotLog, step: float, begin: float, end: float) -> None:
        self.step, self.begin = step, begin
        self.points = max(2, math.floor((end - begin) / step + 1e-9) + 1)
        kinds, stamps, values, shares, streams, reaches = [], [], [], [], [], []
        self.stream_names = [name for name in KINDS_OF_STREAM if name in log.streams]
        for number, name in enumerate(self.stream_names):
            averaged = _averaged(log.streams[name], step, begin)
            for column, kind in enumerate(KINDS_OF_STREAM[name]):
                stamp, value, share, reach = averaged
                shown = np.isfinite(value[:, column]) & (stamp >= begin) & (stamp <= end)
                count = int(np.count_nonzero(shown))
                kinds.append(np.full(count, kind, dtype=np.int64))
                streams.append(np.full(count, number, dtype=np.int64))
                stamps.append(stamp[shown])
                values.append(value[shown, column])
                shares.append(share[shown, column])
                reaches.append(reach[shown])
        self.kind = np.concatenate(kinds) if kinds else np.zeros(0, dtype=np.int64)
        self.stream = np.concatenate(streams) if streams else np.zeros(0, dtype=np.int64)
        self.stamp = np.concatenate(stamps) if stamps else np.zeros(0)
        self.value = np.concatenate(values) if values else np.zeros(0)
        self.share = np.concatenate(shares) if shares else np.zeros(0)
        self.reach = np.concatenate(reaches) if reaches else np.zeros(0)
        order = self.timeline().origin
        self.kind, self.stream, self.stamp = self.kind[order], self.stream[order], self.stamp[order]
        self.value, self.share, self.reach = self.value[order], self.share[order], self.reach[order]

    def timeline(self, timing: Timing = RIGHT) -> Readings:
        """The readings by grid point, at the moments of which they tell when the stamps are off by `timing`."""
        moment = self.stamp.copy()
        for number, name in enumerate(self.stream_names):
            chosen = self.stream == number
            skew, latency = timing.skew.get(name, 0.0), timing.latency.get(name, 0.0)
            if skew != 0.0 or latency != 0.0:
                moment[chosen] = (moment[chosen] - latency) / (1.0 + skew)
        point = np.clip(np.rint((moment - self.begin) / self.step), 0, self.points - 1).astype(np.int64)
        after = moment - self.begin - point * self.step
        order = np.lexsort((self.kind, moment, point))
        apart, side = _around(after, self.reach)
        first = np.searchsorted(point[order], np.arange(self.points + 1)).astype(np.int64)
        return Readings(
            self.step,
            self.begin,
            first,
            self.kind[order],
            after[order],
            apart[order],
            side[order],
            self.stamp[order],
            self.value[order],
            self.share[order],
            order.astype(np.int64),
        )


def _around(after: Floats, reach: Floats) -> tuple[Floats, Floats]:
    """Mean distance from 0 and mean sign of moments that lie evenly in `after` +- `reach`, all (m,)."""
    astride = np.abs(after) < reach
    width = np.where(astride, reach, 1.0)
    apart = np.where(astride, (after**2 + reach**2) / (2.0 * width), np.abs(after))
    return apart, np.where(astride, after / width, np.sign(after))


def _averaged(stream: Stream, step: float, begin: float) -> tuple[Floats, Floats, Floats, Floats]:
    """Stamps (n,), values and shares of variance (n, columns), reach (n,): at most one per grid point, NaN where none.

    The readings that an average is of lie evenly within `reach` [s] of its stamp.
    """
    if len(stream.time) == 0:
        return stream.time, stream.value, np.ones_like(stream.value), stream.time
    point = np.rint((stream.time - begin) / step).astype(np.int64)
    first = np.flatnonzero(np.concatenate([[True], point[1:] != point[:-1]]))
    every = np.diff(np.append(first, len(point))).astype(np.float64)
    stamp = np.add.reduceat(stream.time, first) / every
    given = np.isfinite(stream.value)
    count = np.add.reduceat(given.astype(np.float64), first, axis=0)
    count[count == 0.0] = np.nan
    value = np.add.reduceat(np.where(given, stream.value, 0.0), first, axis=0) / count
    variance = np.add.reduceat((stream.time - np.repeat(stamp, np.diff(np.append(first, len(point))))) ** 2, first)
    return stamp, value, 1.0 / count, np.sqrt(3.0 * variance / every)


def first_values(log: RobotLog, begin: float, window: float) -> dict[int, float]:
    """The first reading of each kind within `window` [s] from `begin`."""
    found: dict[int, float] = {}
    for name, kinds in KINDS_OF_STREAM.items():
        if name not in log.streams:
            continue
        stream = log.streams[name]
        near = (stream.time >= begin) & (stream.time <= begin + window)
        for column, kind in enumerate(kinds):
            values = stream.value[near, column] if near.any() else stream.value[:1, column]
            values = values[np.isfinite(values)]
            if len(values):
                found[kind] = float(values[0])
    return found
