"""Records of the evidence: recordings, robots and streams, cleaned and on one clock, the input of the diagnosis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities
from cocorosim_ros.diagnosis.findings import NO_CLOCK, Clock
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

    noise (columns,): standard deviation of a single reading, estimated from differences; NaN where it does not show.
    time counts from the start of the recording. skew [s/s], skew_error (standard deviation): rate of these stamps above
    the median of the recording's topics, by the log times; NaN where the log times do not show it.
    filled_in: columns of which many readings were interpolated or repeated, and left out.
    full_turn: a full turn of the angle among the columns, 2 pi, or 360 where readings exceed any angle in radians.
    shifted: by how much most stamps were set later [s], since by the log times they were of another clock.
    from_depth: whether these are pressures that a map made of depths, in the contract's fresh water.
    """

    time: Floats
    value: Floats
    noise: Floats
    skew: float = float("nan")
    skew_error: float = float("nan")
    full_turn: float = 2.0 * np.pi
    filled_in: tuple[str, ...] = ()
    shifted: float = 0.0
    from_depth: bool = False


@dataclass(frozen=True)
class Acting:
    """Commands (m, actuators) that act from time (m,) [s] on: angles that actuators reported, and orders beside them.

    reported: names of the actuators whose angles these are.
    """

    time: Floats
    command: Floats
    reported: tuple[str, ...] = ()


@dataclass(frozen=True)
class RobotLog:
    """One robot of one recording.

    command_time (m,) [s], ascending: start of each row of `command` (m, actuators), fractions of the maximum in the
    order of the platform's actuators. command_shifted: by how much most of their stamps were set later [s], as those
    of a stream. way: level velocity of a robot that pitches, whose log shows the speed ahead alone, where its pressure
    tells the rest; a known input, as the attitude is, and no reading. commanded: actuators that its commands name,
    whether the platform has them or not.
    """

    name: str
    command_time: Floats
    command: Floats
    streams: Mapping[str, Stream]
    gaps: tuple[tuple[float, float], ...] = ()  # s: start and end of each gap of the poses
    attitude: Attitude | None = None  # roll and pitch, where they were recorded; None for a robot that stays level
    afloat: tuple[tuple[float, float], ...] = ()  # s: begin and end of each time that it lies at the surface
    clock: Clock = NO_CLOCK
    command_shifted: float = 0.0
    feedback: tuple[Feedback, ...] = ()  # what its actuators report
    way: Velocities | None = None
    commanded: tuple[str, ...] = ()
    acting: Acting | None = None  # None where everything acts as it was ordered
    measured: bool = False  # its commands are what its actuators did, and no orders

    @property
    def acts(self) -> Acting:
        """Commands that act: with reported angles where there are any, else as they were ordered."""
        return self.acting or Acting(self.command_time, self.command)


@dataclass(frozen=True)
class RecordingLog:
    """One bag: its robots, its duration [s], and remarks about it, as sentences.

    made_from: text of the scenario that it was made from; empty where it tells none.
    """

    origin: str
    duration: float
    robots: tuple[RobotLog, ...]
    remarks: tuple[str, ...] = ()
    made_from: str = ""


@dataclass(frozen=True)
class Evidence:
    """The whole input of a diagnosis: recordings of robots of one platform."""

    platform: Platform
    recordings: tuple[RecordingLog, ...]

    @property
    def remarks(self) -> tuple[str, ...]:
        """Remarks on the platform and on all recordings, as sentences."""
        robots = self.platform.robots.values()
        on_platform = dict.fromkeys(remark for each in (self.platform, *robots) for remark in each.told)
        return (*on_platform, *self.remarks_on_recordings)

    @property
    def remarks_on_recordings(self) -> tuple[str, ...]:
        """Remarks on all recordings, as sentences."""
        return tuple(remark for recording in self.recordings for remark in recording.remarks)


def told_apart(recordings: Sequence[RecordingLog]) -> tuple[RecordingLog, ...]:
    """Begin every remark with the name of its recording, where there are several recordings."""
    if len(recordings) < 2:
        return tuple(recordings)
    return tuple(replace(each, remarks=tuple(_with_origin(each, remark) for remark in each.remarks))
                 for each in recordings)  # fmt: skip


def _with_origin(recording: RecordingLog, remark: str) -> str:
    place = f"{recording.origin}: "
    return remark if remark.startswith(place) else place + remark
