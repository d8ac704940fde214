"""One robot in one recording, and the filter's pass over it under given numbers."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Callable
from copy import copy
from dataclasses import dataclass
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import Recording, RobotLog
from cocorosim_ros.diagnosis.filter.commands import mean_forces
from cocorosim_ros.diagnosis.filter.covariance import GATE
from cocorosim_ros.diagnosis.filter.filter import filter_pass, slope_pass
from cocorosim_ros.diagnosis.filter.layout import (
    ANGLES,
    COMPASS,
    KIND_NAMES,
    KINDS_OF_STREAM,
    POSE_X,
    POSE_Y,
    POSE_YAW,
    POSE_Z,
    PRESSURE,
)
from cocorosim_ros.diagnosis.filter.motion import run_free
from cocorosim_ros.diagnosis.filter.records import Belief, Drive, History, Past, Readings
from cocorosim_ros.diagnosis.filter.smoother import smooth
from cocorosim_ros.diagnosis.tracks import columns
from cocorosim_ros.diagnosis.tracks.columns import (
    ACTUATING,
    COLUMN,
    PHYSICS,
    READING_COLUMNS,
    SENSORS,
    TIMING,
    WATER,
    active_effects,
)
from cocorosim_ros.diagnosis.tracks.reading_laws import law_shift, without_laws
from cocorosim_ros.diagnosis.tracks.timeline import Timing, TrackReadings, first_values, grid_begin, grid_step
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.world.motion.actuation import ACTUATION_BITS
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE, SURFACE_PRESSURE
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE
from cocorosim_ros.world.tick.assembly import build_vehicles
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, Body
from cocorosim_ros.world.water.flow import make_flow

STILL = make_flow([])
NO_PUSH = np.zeros((0, 4))
REMEMBERED = 6  # drives and timelines of a track, for numbers asked for again
TIMELINE = -1  # in the place of the effects of a drive
FIRST_SECONDS = 0.5  # s in which the start is looked for


@dataclass(frozen=True)
class Pass:
    """What a pass of the filter leaves, each (m,) in the order of the track's readings, gain (m, HORIZONTAL)."""

    innovation: Floats
    variance: Floats
    gain: Floats
    believed: Flags  # innovations within the gate
    log_likelihood: float


@dataclass(frozen=True)
class Smoothed:
    """time (points,) [s]; mean, spread (points, 12): x y z yaw u v w r, random force x y z [N; world], moment [N m]."""

    time: Floats
    mean: Floats
    spread: Floats


def _known_of_sensors(platform: Platform) -> dict[str, float]:
    """By column, what the platform's file says of sensors and stamps."""
    found = {}
    for effect, parameters in platform.effects.items():
        for name, value in parameters.items():
            column = f"{effect}.{name}"
            if column in COLUMN and effect not in EFFECT_BIT:
                found[column] = value
    return found


def _blank_history(points: int) -> History:
    means = [np.zeros((points, 16)) for _ in range(2)]
    wide, high = ([np.zeros((points, size, size)) for _ in range(3)] for size in (HORIZONTAL, VERTICAL))
    return History(*means, *wide, *high)


class Track:
    """One robot in one recording; `robot` and `recording` are numbers, `row` the base model's numbers."""

    def __init__(self, platform: Platform, recording: Recording, log: RobotLog, span: tuple[float, float]) -> None:
        platform = platform.of_robot(log.name)
        vehicles = build_vehicles([platform])
        self.name, self.origin, self.log = log.name, recording.origin, log
        self._wrench, self._limit = vehicles.actuator_wrench[0, 0], vehicles.actuator_limit[0, 0]
        self.known = _known_of_sensors(platform)
        self.hull, self.ranges = platform.hull.length, platform.ranges
        thrusters = [part.position[0] for part in platform.actuators if isinstance(part, Thruster)]
        self.arm = float(np.mean(thrusters)) if thrusters else 0.0
        self._pump = vehicles.is_pump[0, 0]
        self.water = (np.full(3, -1e6), np.full(3, 1e6))  # lowest and highest corner [m; world]
        self.around, self.own = np.zeros((1, 0, NEIGHBOUR_SIZE)), -1
        self._active = int(vehicles.active[0, 0]) | columns.ALWAYS_ACTIVE
        self.platform_row = vehicles.parameters[0, 0]
        self.force_scale = np.abs(self._wrench * self._limit[:, :1]).sum(axis=0)  # (4,) N, N, N, N m
        step = grid_step(
            float(np.linalg.norm(self.force_scale[:3])) / platform.mass, self.force_scale[3] / platform.yaw_inertia
        )
        begin = grid_begin(log.command_time, step, span[0])
        self.readings = TrackReadings(log, step, begin, span[1])
        self._by_numbers: OrderedDict[tuple[int, bytes], Any] = OrderedDict()
        self.is_angle = np.isin(self.readings.kind, ANGLES)
        self.start = self._start(span[0])
        self._course: Course | None = None  # along which laws of readings are taken

    def _start(self, begin: float) -> Floats:
        """(2, 8) state at the first grid point and its standard deviation."""
        first = first_values(self.log, begin, FIRST_SECONDS)
        mean, spread = np.zeros(STATE_SIZE), np.full(STATE_SIZE, 1.0)
        mean[X], mean[Y] = first.get(POSE_X, 0.0), first.get(POSE_Y, 0.0)
        height = -(first[PRESSURE] - SURFACE_PRESSURE) / PASCAL_PER_METRE if PRESSURE in first else 0.0
        mean[Z] = first.get(POSE_Z, height)
        mean[YAW] = first.get(POSE_YAW, first.get(COMPASS, 0.0))
        spread[X] = spread[Y] = spread[Z] = 0.05
        spread[YAW] = 0.2
        mass = self.platform_row[0]
        speed = max(0.05, math.sqrt(self.force_scale[0] / mass) * 0.5)
        spread[SURGE] = spread[SWAY] = spread[HEAVE] = speed
        spread[YAW_RATE] = max(0.3, math.sqrt(self.force_scale[3] / self.platform_row[1]))
        return np.array([mean, spread])

    def body(self, row: Floats) -> Body:
        """The simulator's body under these numbers; effects whose numbers are not neutral are switched on."""
        active = self._active | active_effects(row)
        return Body(
            row[PHYSICS].copy(), active, self._wrench, self._limit, self._pump, STILL, *self.water, *self._nobody()
        )

    def _nobody(self) -> tuple[Floats, int]:
        robots = self.around.shape[1]
        return np.zeros((robots, NEIGHBOUR_SIZE)), -1 if robots == 0 else self.own

    def drive(self, row: Floats) -> Drive:
        """What acts on the robot between grid points, as the commands and these numbers have it."""
        body = self.body(row)
        force, rate = self._once(
            (body.active & ACTUATION_BITS, row[ACTUATING].tobytes()),
            lambda: mean_forces(self.log.command_time, self.log.command, body, self._grid()),
        )
        return Drive(force, rate, self.around)

    def _grid(self) -> tuple[float, float, int]:
        return self.readings.begin, self.readings.step, self.readings.points

    def _once(self, key: tuple[int, bytes], made: Callable[[], Any]) -> Any:
        """What `made` returns, from memory if it was asked for lately."""
        if key not in self._by_numbers:
            self._by_numbers[key] = made()
            if len(self._by_numbers) > REMEMBERED:
                self._by_numbers.popitem(last=False)
        self._by_numbers.move_to_end(key)
        return self._by_numbers[key]

    def thrust(self, row: Floats) -> Floats:
        """(points, 4) wrench of the thrusters [N, N, N, N m; body]."""
        return np.asarray(self.drive(row).force[:, ~self._pump] @ self._wrench[~self._pump])

    def pump_force(self, row: Floats) -> Floats:
        """(points,) force of the pumps [N], up positive."""
        return np.asarray(self.drive(row).force[:, self._pump].sum(axis=1))

    def nominal_force(self) -> Floats:
        """(points, 2) forward and sideways force of the thrusters [N] under the platform's own numbers."""
        row = columns.NEUTRAL.copy()
        row[PHYSICS] = self.platform_row
        return np.asarray(self.drive(row).force[:, ~self._pump] @ self._wrench[~self._pump, :2])

    def timeline(self, row: Floats) -> Readings:
        """The readings on the grid, at the moments of which they tell."""
        off = row[TIMING]
        latency, skew = off.reshape(2, len(KINDS_OF_STREAM)).tolist()
        timing = Timing(dict(zip(KINDS_OF_STREAM, latency, strict=True)), dict(zip(KINDS_OF_STREAM, skew, strict=True)))
        found: Readings = self._once((TIMELINE, off.tobytes()), lambda: self.readings.timeline(timing))
        shift = law_shift(row, found, lambda: self._seen_course(row))
        return found if shift is None else found._replace(value=found.value - shift)

    def law_shift(self, row: Floats) -> Floats:
        """(m,) what laws of readings in this row add, in the order of the track."""
        found, shift = self.timeline(without_laws(row)), np.zeros(len(self.readings.kind))
        added = law_shift(row, found, lambda: self._seen_course(row))
        if added is not None:
            shift[found.origin] = added
        return shift

    def _seen_course(self, row: Floats) -> Course:
        """What laws of readings depend on, as the first model that asks for it saw the robot swim."""
        if self._course is None:
            plain = without_laws(row)
            self._course = self.course_along(self.smoothed(plain), plain)
        return self._course

    def course_along(self, smoothed: Smoothed, row: Floats) -> Course:
        """What laws may depend on, where the robot swam so and its actuators have these numbers."""
        row = row.copy()
        row[COLUMN["law_1.phase"]] += 1.0  # rates of actuators are reckoned for those who may ask, as this law
        drive, points = self.drive(row), len(smoothed.time)
        return Course(
            smoothed.time, smoothed.mean, self.thrust(row), drive.force, drive.rate, self._pump, self.water,
            self.around[:points], self.own,
        )  # fmt: skip

    def full(self, row: Floats) -> Pass:
        """The filter's pass: likelihood, innovations, gains."""
        innovation, variance, gain, _ = self._believe(row, _blank_history(0))
        sound = (variance > 0.0) & np.isfinite(variance) & np.isfinite(innovation)
        if not sound.all():  # numbers under which the model cannot be run
            innovation, variance = np.where(sound, innovation, 0.0), np.where(sound, variance, 1.0)
        squared = innovation**2 / variance
        likelihood = -0.5 * float(np.sum(squared + np.log(2.0 * math.pi * variance))) if sound.all() else -math.inf
        return Pass(innovation, variance, gain, squared < GATE * GATE * (1.0 - 1e-9), likelihood)

    def smoothed(self, row: Floats) -> Smoothed:
        """The most likely course given all readings, before and after each moment."""
        history = self._believe(row, _blank_history(self.readings.points)).history
        mean, spread = smooth(history)
        time: Floats = self.readings.begin + self.readings.step * np.arange(self.readings.points, dtype=np.float64)
        return Smoothed(time, mean[:, :12], spread[:, :12])

    def free_run(self, row: Floats, start: Floats, first: int, points: int, push: Floats = NO_PUSH) -> Floats:
        """(points, 8) the model's own course from `start` (8,) at grid point `first`, no reading heeded.

        push (points, 4): random force, world x, y, z [N] and moment [N m], that acts beside the model.
        """
        clock = (self.readings.begin, self.readings.step)
        path: Floats = run_free(self.drive(row), start, self.body(row), clock, (first, points, push))
        return path

    def until(self, share: float) -> Track:
        """The first part of this track, up to `share` of its duration."""
        part = copy(self)
        end = self.readings.begin + share * self.readings.step * (self.readings.points - 1)
        part.readings = TrackReadings(self.log, self.readings.step, self.readings.begin, end)
        part._by_numbers = OrderedDict()
        part.is_angle = np.isin(part.readings.kind, ANGLES)
        return part

    def sees(self, *names: str) -> bool:
        """Whether there are readings of one of these kinds."""
        return bool(np.isin(self.readings.kind, [KIND_NAMES.index(name) for name in names]).any())

    def _believe(self, row: Floats, kept: History) -> Belief:
        count = len(self.readings.kind)
        belief = Belief(np.empty(count), np.empty(count), np.zeros((count, HORIZONTAL)), kept)
        numbers = (row[SENSORS], np.exp(row[WATER]), np.exp(2.0 * row[READING_COLUMNS]))
        filter_pass(self.timeline(row), self.drive(row), self.start, self.body(row), numbers, belief)
        return belief

    def slope(self, row: Floats, past: Pass, step: float, slope: Floats) -> None:
        """Write (m,) how the innovations of a pass change, gains held, by the number that is `step` off in this row.

        0 where the past pass did not believe the reading.
        """
        numbers = (row[SENSORS], np.exp(row[WATER]), step)
        kept = Past(past.innovation, past.gain, past.believed)
        slope_pass(self.timeline(row), self.drive(row), self.start[0], self.body(row), numbers, kept, slope)
