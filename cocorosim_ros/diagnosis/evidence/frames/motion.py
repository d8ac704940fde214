"""Streams of one robot on one coarse grid of time, as velocities and rates that can be compared with each other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AGREEMENT, BINS
from cocorosim_ros.diagnosis.evidence.frames.expected import Complex, Expected, expected_motion
from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS, RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import (
    AMBIENT,
    FELT_X,
    FELT_Y,
    HEADING,
    TURN_RATE,
    VELOCITIES,
    YAW,
    U,
    V,
    W,
    X,
    Y,
    Z,
)
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import coasting_time
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform


@dataclass(frozen=True)
class Courses:
    """Velocities x + iy (n,) [m/s; world] that are expected under the commands, and under their mirror image.

    A hull that slips freely coasts on in the world as it turns; one that is led, by its wings or its length, takes its
    velocity along. Vehicles lie between the two.
    """

    commanded: Complex
    mirrored: Complex  # left and right exchanged
    led: Complex
    led_mirrored: Complex

    def under(self, mirrored: int) -> tuple[Complex, Complex]:
        """Courses under the commands, or (1) under their mirror image, of a hull that slips and of one that is led."""
        return (self.mirrored, self.led_mirrored) if mirrored else (self.commanded, self.led)


@dataclass(frozen=True)
class ShownMotion:
    """Motion at n moments `width` [s] apart, each worth `weight` of an independent one; NaN without a reading.

    course: velocity x + iy [world]; climb: of z; yaw [rad], turn: of yaw; heading [rad], swing: of the compass; gyro;
    pulled: x + iy of the accelerometer; moved: u + iv of the velocity of each of the topics VELOCITIES, lift: its w;
    sinking: rate of the pressure.

    Expected under the commands, with the heading that is known best: advance: u + iv, shove: its acceleration [body],
    dive: w, spin: r; by_yaw and by_compass: courses under either heading.
    """

    width: float
    weight: float
    course: Complex
    climb: Floats
    yaw: Floats
    turn: Floats
    heading: Floats
    swing: Floats
    gyro: Floats
    pulled: Complex
    moved: Mapping[str, Complex]
    lift: Mapping[str, Floats]
    sinking: Floats
    advance: Complex
    shove: Complex
    dive: Floats
    spin: Floats
    by_yaw: Courses
    by_compass: Courses


def motion_of(log: RobotLog, platform: Platform) -> ShownMotion:
    """The motion that each stream of a log shows."""
    bins = _Bins(log, coasting_time(platform))
    pose, pose_rate = bins.stream(log, "pose")
    compass, compass_rate = bins.stream(log, "compass")
    imu, _ = bins.stream(log, "imu")
    velocity = {topic: bins.stream(log, topic)[0] for topic in VELOCITIES}
    _, pressure_rate = bins.stream(log, "pressure")
    expected = expected_motion(log, platform)
    advance, shove = _in_body(bins, log, expected)
    unknown = np.full(bins.count, np.nan)
    return ShownMotion(
        width=bins.width,
        weight=bins.width / max(AGREEMENT.least_memory, AGREEMENT.memory * coasting_time(platform)),
        course=np.asarray(pose_rate[:, X] + 1j * pose_rate[:, Y]),
        climb=pose_rate[:, Z],
        yaw=pose[:, YAW],
        turn=pose_rate[:, YAW],
        heading=compass[:, HEADING],
        swing=compass_rate[:, HEADING],
        gyro=imu[:, TURN_RATE],
        pulled=np.asarray(imu[:, FELT_X] + 1j * imu[:, FELT_Y]),
        moved={topic: np.asarray(value[:, U] + 1j * value[:, V]) for topic, value in velocity.items()},
        lift={topic: value[:, W] for topic, value in velocity.items()},
        sinking=pressure_rate[:, AMBIENT],
        advance=advance,
        shove=shove,
        dive=bins.mean(expected.time, expected.dive) if expected else unknown,
        spin=bins.mean(expected.time, expected.spin) if expected else unknown,
        by_yaw=_by_heading(bins, log, expected, "pose", YAW),
        by_compass=_by_heading(bins, log, expected, "compass", HEADING),
    )


def motion_together(logs: Sequence[RobotLog], platform: Platform) -> ShownMotion:
    """The motions of several logs, one after the other."""
    motions = [motion_of(log, platform) for log in logs]
    if len(motions) == 1:
        return motions[0]
    parts = {
        field.name: _behind_each_other([getattr(motion, field.name) for motion in motions])
        for field in fields(ShownMotion)
        if field.name not in ("width", "weight")
    }
    width, weight = (float(np.median([getattr(motion, name) for motion in motions])) for name in ("width", "weight"))
    return ShownMotion(width=width, weight=weight, **parts)


def _behind_each_other(parts: Sequence[Any]) -> Any:
    if isinstance(parts[0], Mapping):
        return {topic: np.concatenate([part[topic] for part in parts]) for topic in parts[0]}
    if isinstance(parts[0], Courses):
        return Courses(*(np.concatenate([getattr(part, field.name) for part in parts]) for field in fields(Courses)))
    return np.concatenate(parts)


class _Bins:
    """Bins of equal width over a whole log; values to be compared stand at the edges between two bins."""

    def __init__(self, log: RobotLog, coasting: float) -> None:
        streams = list(log.streams.values())
        slow = [np.median(np.diff(stream.time)) for stream in streams if len(stream.time) > 2]
        wanted = max([BINS.narrowest, *(BINS.readings * interval for interval in slow)])
        told = min(wanted, max(BINS.widest, BINS.widest_coasting * coasting))
        self.width = float(max(told, min(BINS.narrow * coasting, BINS.widest)))
        self.start = min((float(stream.time[0]) for stream in streams), default=0.0)
        end = max((float(stream.time[-1]) for stream in streams), default=0.0)
        self.count = max(int((end - self.start) / self.width), 1)

    def stream(self, log: RobotLog, topic: str) -> tuple[Floats, Floats]:
        """Values (n, columns) and rates (n, columns) at the edges; NaN if the log has no such stream."""
        if topic not in log.streams:
            nothing = np.full((self.count, len(STREAMS[topic])), np.nan)
            return nothing, nothing
        stream = log.streams[topic]
        means, slopes = zip(*(self._edges(stream.time, column) for column in stream.value.T), strict=True)
        return np.column_stack(means), np.column_stack(slopes)

    def mean(self, time: Floats, column: Floats) -> Floats:
        """Values (n,) at the edges."""
        return self._edges(time, column)[0]

    def complex_mean(self, time: Floats, column: Complex) -> Complex:
        """Complex values (n,) at the edges."""
        return np.asarray(self.mean(time, column.real) + 1j * self.mean(time, column.imag))

    def _edges(self, time: Floats, column: Floats) -> tuple[Floats, Floats]:
        """The mean of two neighbouring bins, and the slope between their means."""
        place = ((time - self.start) / self.width).astype(int)
        chosen = (place >= 0) & (place <= self.count) & np.isfinite(column)
        here = place[chosen]
        size = np.bincount(here, minlength=self.count + 1).astype(float)
        size[size == 0.0] = np.nan
        moment = np.bincount(here, time[chosen], self.count + 1) / size
        mean = np.bincount(here, column[chosen], self.count + 1) / size
        return 0.5 * (mean[1:] + mean[:-1]), np.diff(mean) / np.diff(moment)


def _by_heading(bins: _Bins, log: RobotLog, expected: Expected | None, topic: str, column: int) -> Courses:
    angle = _angle(log, expected, topic, column)
    if expected is None or angle is None:
        unknown = np.full(bins.count, np.nan) + 0j
        return Courses(unknown, unknown, unknown, unknown)

    def shown(mirrored: bool) -> list[Complex]:
        courses = expected.course(angle, mirrored=mirrored).velocity, expected.led(angle, mirrored=mirrored)
        return [bins.complex_mean(expected.time, course) for course in courses]

    slipping, led = shown(mirrored=False)
    slipping_mirrored, led_mirrored = shown(mirrored=True) if expected.push.imag.any() else (slipping, led)
    return Courses(slipping, slipping_mirrored, led, led_mirrored)


def _in_body(bins: _Bins, log: RobotLog, expected: Expected | None) -> tuple[Complex, Complex]:
    """Expected velocity and acceleration under the commands, in body axes."""
    if expected is None:
        unknown = np.full(bins.count, np.nan) + 0j
        return unknown, unknown
    angle = np.cumsum(expected.spin) * (expected.time[1] - expected.time[0])
    for topic, column in (("compass", HEADING), ("pose", YAW)):
        known = _angle(log, expected, topic, column)
        angle = angle if known is None else known
    into_body = np.exp(-1j * angle)
    course = expected.course(angle)
    velocity, acceleration = course.velocity * into_body, course.acceleration * into_body
    return bins.complex_mean(expected.time, velocity), bins.complex_mean(expected.time, acceleration)


def _angle(log: RobotLog, expected: Expected | None, topic: str, column: int) -> Floats | None:
    """Heading (n,) of a stream at the moments of the expected motion; None if the stream has no readings."""
    stream = log.streams.get(topic)
    if stream is None or expected is None:
        return None
    given = np.isfinite(stream.value[:, column])
    if not given.any():
        return None
    return np.asarray(np.interp(expected.time, stream.time[given], stream.value[given, column]))
