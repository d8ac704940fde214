"""State of a robot when its recording began, from the first readings.

Where a model has errors of the instruments that showed the first place and heading, its start is where these readings
put it with their errors: a camera of which all lengths are 15 % too large saw a robot 3.45 m from the origin that
began 3 m from it. A start that stayed at 3.45 m would speak against that camera in every recording, and for the other
instrument of two that disagree.

The first place is as sure as the reading that showed it, and less if that came later than the start: one that is off by
a metre, and is believed to 5 cm, bends all that comes behind it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import START
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.filter.layout import (
    COMPASS,
    KIND_NAMES,
    KINDS_OF_STREAM,
    POSE_X,
    POSE_Y,
    POSE_YAW,
    POSE_Z,
    PRESSURE,
)
from cocorosim_ros.diagnosis.filter.reading import NO_MOTORS, Along, deviation, expected_along
from cocorosim_ros.diagnosis.filter.records import Start
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.diagnosis.tracks.vehicle_size import slowness
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors.errors import NEUTRAL, changes_of
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z

_SHOWN_BY = {X: (POSE_X,), Y: (POSE_Y,), Z: (POSE_Z, PRESSURE), YAW: (POSE_YAW, COMPASS)}
"""Kinds of readings that show a number of the state, by that number; the one that is believed comes first."""


class Shown(NamedTuple):
    """The first reading of a kind: its value, how much such readings err, and when it came."""

    value: float
    noise: float  # standard deviation, 0 where it does not show
    wait: float  # from the start to it [s]


class FirstReading(NamedTuple):
    """The first reading of a number of the state."""

    state: int
    kind: int
    shown: Shown

    @property
    def value(self) -> float:
        """Value of the reading, in its own unit."""
        return self.shown.value


class Beginning(NamedTuple):
    """The start of a track as the first readings show it, these readings, and the moment [s] of the start."""

    start: Start
    shown: tuple[FirstReading, ...]
    moment: float

    def under(self, sensor: Floats) -> Start:
        """Return the start under the errors of sensors (numbers by SENSOR_COLUMNS): where these readings put it.

        Place by place by secant steps, which are exact for errors that are linear. Errors that depend on what motors
        do, or on the water, have nothing to depend on yet.
        """
        wrong = [each for each in self.shown if _has_errors(each.kind, sensor)]
        if not wrong:
            return self.start
        mean = self.start.mean.copy()
        for each in wrong * START.steps:
            left, near = (self._left(each, mean, off, sensor) for off in (0.0, START.secant))
            slope = (left - near) / START.secant
            if slope != 0.0:
                mean[each.state] += left / slope
        return self.start._replace(mean=mean)

    def at(self, start: Start) -> Beginning:
        """Return another start, which is the same under all errors of sensors."""
        return Beginning(start, (), self.moment)

    def _left(self, reading: FirstReading, mean: Floats, off: float, sensor: Floats) -> float:
        """Tell what a first reading shows beyond what is expected at a start with one number of its mean `off`."""
        state = mean[None].copy()
        state[0, reading.state] += off
        shown = np.empty(1)
        along = Along(np.array([self.moment]), state, np.zeros((1, 4)))
        expected_along(reading.kind, along, NO_MOTORS, sensor, shown)
        return float(deviation(reading.kind, reading.value, float(shown[0])))


def _has_errors(kind: int, sensor: Floats) -> bool:
    columns = [column for _, numbers in changes_of(KIND_NAMES[kind]) for column in numbers]
    return any(sensor[column] != NEUTRAL[column] for column in columns)


def beginning_of(vehicle: VehicleModel, log: RobotLog, begin: float) -> Beginning:
    """Guess the state at the first grid point, and its standard deviation, from readings soon after `begin` [s].

    Numbers that no reading shows are 0; speeds are uncertain by what full thrust may reach.
    """
    shown = tuple(_shown(first_readings(log, begin, START.window)))
    mean, spread = np.zeros(STATE_SIZE), np.full(STATE_SIZE, 1.0)
    slow = slowness(vehicle)
    force, moment = vehicle.force_scale[0], vehicle.force_scale[3]
    speed = max(START.least_speed / slow, math.sqrt(force / vehicle.mass) * START.speed_share)
    spread[X] = spread[Y] = spread[Z] = START.place
    for each in shown:
        scale = 1.0 / vehicle.water_weight if each.kind == PRESSURE else 1.0
        mean[each.state] = -(each.value - SURFACE_PRESSURE) * scale if each.kind == PRESSURE else each.value
        if each.state in (X, Y, Z):
            spread[each.state] = max(START.place, START.of_noise * scale * each.shown.noise, speed * each.shown.wait)
    spread[YAW] = START.yaw
    spread[SURGE] = spread[SWAY] = spread[HEAVE] = speed
    spread[YAW_RATE] = max(START.least_turn / slow, math.sqrt(moment / vehicle.yaw_inertia))
    return Beginning(Start(mean, spread), shown, begin)


def _shown(first: dict[int, Shown]) -> Iterator[FirstReading]:
    """The first reading of each number of the state that any shows; first: readings by kind."""
    for state, kinds in _SHOWN_BY.items():
        kind = next((kind for kind in kinds if kind in first), None)
        if kind is not None:
            yield FirstReading(state, kind, first[kind])


def first_readings(log: RobotLog, begin: float, window: float) -> dict[int, Shown]:
    """First readings by kind, within `window` [s] from `begin` [s].

    Of a stream that is silent there it is its next reading.
    """
    found: dict[int, Shown] = {}
    for name, kinds in KINDS_OF_STREAM.items():
        if name not in log.streams:
            continue
        stream = log.streams[name]
        later = np.flatnonzero(stream.time >= begin)
        near = later[stream.time[later] <= begin + window]
        chosen = near if len(near) else later[:1]
        for column, kind in enumerate(kinds):
            given = chosen[np.isfinite(stream.value[chosen, column])]
            if len(given):
                noise, wait = float(stream.noise[column]), float(stream.time[given[0]]) - begin
                found[kind] = Shown(float(stream.value[given[0], column]), noise if noise > 0.0 else 0.0, wait)
    return found
