"""What one or several recordings say of each robot, cleaned and on one clock: the input of the diagnosis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.sensors import SENSORS

STREAMS: dict[str, tuple[str, ...]] = {
    topic: tuple(kind.column for kind in sensor.kinds) for topic, sensor in SENSORS.items() if sensor.kinds
}
"""Columns of each stream's values, in the units of the sensor's kinds; angles are not wrapped."""


@dataclass(frozen=True)
class Stream:
    """One topic of one robot: stamps (n,) [s], ascending, and values (n, columns of STREAMS), NaN where not given.

    noise (columns,): standard deviation of a single reading, estimated from differences; NaN where nothing is shown.
    time counts from the start of the recording. skew [s/s], skew_error (standard deviation): how much faster these
    stamps run than the median of the recording's topics, by the log times; NaN where the log times do not show it.
    full_turn: what the angle among the columns counts for a turn, 360 where its readings go beyond any radians.
    """

    time: Floats
    value: Floats
    noise: Floats
    skew: float = float("nan")
    skew_error: float = float("nan")
    full_turn: float = 2.0 * np.pi


@dataclass(frozen=True)
class RobotLog:
    """One robot of one recording.

    command_time (m,) [s], ascending: from when the row of `command` (m, actuators) holds, fractions of the maximum in
    the order of the platform's actuators.
    """

    name: str
    command_time: Floats
    command: Floats
    streams: Mapping[str, Stream]
    gaps: tuple[tuple[float, float], ...] = ()  # s: from when to when the poses are missing for long


@dataclass(frozen=True)
class Recording:
    """One bag: its robots, how long it is [s], and what was noticed while it was read (sentences)."""

    origin: str
    duration: float
    robots: tuple[RobotLog, ...]
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Evidence:
    """All that the diagnosis is given: recordings of robots of one platform."""

    platform: Platform
    recordings: tuple[Recording, ...]


def told_apart(recordings: Sequence[Recording]) -> tuple[Recording, ...]:
    """The recordings; where there are several, every remark begins with the one that it is about."""
    if len(recordings) < 2:
        return tuple(recordings)
    return tuple(replace(each, remarks=tuple(_with_origin(each, remark) for remark in each.remarks))
                 for each in recordings)  # fmt: skip


def _with_origin(recording: Recording, remark: str) -> str:
    place = f"{recording.origin}: "
    return remark if remark.startswith(place) else place + remark
