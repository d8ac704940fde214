"""What a plain Python controller is given each tick: all that its robot senses and hears, and nothing else."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.sensor_axes import cone_axis
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH
from cocorosim_ros.world.state.sound import RANGE

Messages = tuple[tuple[float, ...], ...]
Vector3 = tuple[float, float, float]


class Sound(NamedTuple):
    """One message that came in by sound."""

    numbers: tuple[float, ...]
    range: float
    """To where the sender was when it spoke, by the time that sound took [m]."""


class Sensed(NamedTuple):
    """What one robot knows at one moment. NaN: an instrument gave nothing; +inf: a range that found nothing.

    Frames: world is east-north-up, body is forward-left-up. Arrays cannot be written to and are the controller's to
    keep.
    """

    robot: str
    """Its own name."""
    time: float
    """[s] since the start of the run."""
    heading: float
    """Of the compass, in (-pi, pi], counter-clockwise from +x [rad; world]."""
    pressure: float
    """Absolute [Pa]."""
    depth: float
    """By the pressure, down positive [m]."""
    angular_rate: Floats
    """(3,) of the gyro [rad/s; body]; the last is the yaw rate."""
    specific_force: Floats
    """(3,) of the accelerometer [m/s^2; body]; +9.81 upwards at rest."""
    velocity: Floats
    """(4,) the robot's own estimate through the water: u, v, w [m/s; body] and r [rad/s]."""
    neighbour_range: Mapping[str, float]
    """Of the nearest robot, by the name of the blue-light sensor that sees it [m]."""
    obstacle_range: Mapping[str, float]
    """Of the nearest obstacle or wall, by the name of the blue-light or obstacle sensor [m]."""
    sensor_axis: Mapping[str, Vector3]
    """Where each blue-light or obstacle sensor looks: unit vector [body]."""
    actuators: tuple[str, ...]
    """The names that a command may have."""
    heard: Messages
    """What came in by radio since the last tick: the numbers of each message, in the order of the senders."""
    heard_by_light: Messages
    """What came in over blue light; where the class has `blue_light_rx` in `needs`."""
    heard_by_sound: tuple[Sound, ...]
    """What came in by sound, with ranges; where the class has `acoustic_rx` in `needs`."""
    illuminance: float
    """Ambient light [lx]; where the class has `illuminance` in `needs`."""
    concentration: float
    """Of the plume [kg/m^3]; where the class has `concentration` in `needs`."""
    neighbour_offset: Floats
    """(n, 3) true places of the robots near it [m; body]; where the class has `neighbours` in `needs`."""
    neighbour_velocity: Floats
    """(n, 3) their true velocities [m/s; world]."""


class Senses:
    """Turns the observations of one robot into what its plain Python controller is given."""

    def __init__(self, robot: RobotDescription) -> None:
        platform = robot.platform
        self._robot = robot.name
        self._instruments = platform.sensors
        self._names = tuple(sensor.name for sensor in platform.sensors.directed)
        self._axes = MappingProxyType({sensor.name: cone_axis(sensor) for sensor in platform.sensors.directed})
        self._actuators = platform.actuator_names
        self._pressure_per_metre = platform.water_density * platform.gravity

    def see(self, observation: Observation) -> Sensed:
        """What the robot's controller is given. An instrument that the platform lacks shows NaN."""
        has = self._instruments
        pressure = float(observation.pressure) if has.pressure else np.nan
        near = observation.neighbour_count
        return Sensed(
            robot=self._robot,
            time=float(observation.time),
            heading=float(observation.compass) if has.compass else np.nan,
            pressure=pressure,
            depth=(pressure - SURFACE_PRESSURE) / self._pressure_per_metre,
            angular_rate=_kept(observation.angular_rate, has.imu),
            specific_force=_kept(observation.specific_force, has.imu),
            velocity=_kept(observation.velocity, has.velocity),
            neighbour_range=self._ranges(observation.neighbour_range),
            obstacle_range=self._ranges(observation.obstacle_range),
            sensor_axis=self._axes,
            actuators=self._actuators,
            heard=_messages(observation.heard, int(observation.heard_count)),
            heard_by_light=_messages(observation.light, int(observation.light_count)),
            heard_by_sound=_sounds(observation.sound, int(observation.sound_count)),
            illuminance=float(observation.illuminance),
            concentration=float(observation.concentration),
            neighbour_offset=_kept(observation.neighbour_offset[:near]),
            neighbour_velocity=_kept(observation.neighbour_velocity[:near]),
        )

    def _ranges(self, ranges: Floats) -> Mapping[str, float]:
        """By sensor; one that gave no number sees nothing."""
        known = [np.inf if math.isnan(value) else value for value in ranges.tolist()]
        return MappingProxyType(dict(zip(self._names, known, strict=False)))


def _kept(array: Floats, is_there: bool = True) -> Floats:
    """A copy that cannot be written to, NaN where there is no such instrument."""
    kept = np.array(array) if is_there else np.full(array.shape, np.nan)
    kept.flags.writeable = False
    return kept


def _sounds(rows: Floats, count: int) -> tuple[Sound, ...]:
    ranges = rows[:count, RANGE].tolist()
    return tuple(Sound(*heard) for heard in zip(_messages(rows, count), ranges, strict=True))


def _messages(rows: Floats, count: int) -> Messages:
    return tuple(tuple(row[1 : 1 + int(row[MESSAGE_LENGTH])]) for row in rows[:count].tolist())
