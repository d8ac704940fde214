"""SENSOR_EFFECTS: how instruments are wrong by a law, by the identifiers of the catalogue.

What is random in readings is corruption (sensors.corruption), not an effect.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine, wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.state.readings import Readings
from cocorosim_ros.world.state.state import YAW

LATE_TOPICS = ("compass", "pressure", "imu", "velocity")
"""The streams whose latency a simulation has (sensors.latency)."""


@dataclass(frozen=True)
class SensorEffect:
    """What it is, and its numbers."""

    summary: str
    parameters: tuple[Parameter, ...]


SENSOR_EFFECTS: dict[str, SensorEffect] = {
    "compass_distortion": SensorEffect(
        "the compass shows yaw + offset + sin * sin(yaw) + cos * cos(yaw)",
        (
            Parameter("offset", "rad", "the same at every heading"),
            Parameter("sin", "rad", "times the sine of the heading"),
            Parameter("cos", "rad", "times the cosine of the heading"),
        ),
    ),
    "pressure_offset": SensorEffect(
        "the pressure sensor shows too much", (Parameter("offset", "Pa", "reading less truth"),)
    ),
    "pressure_drift": SensorEffect(
        "the reading of the pressure sensor drifts", (Parameter("rate", "Pa/s", "change of the reading in time"),)
    ),
    "imu_bias": SensorEffect(
        "the IMU is off by a constant",
        (
            Parameter("gyro_z", "rad/s", "reading less truth"),
            Parameter("accel_x", "m/s^2", "reading less truth"),
            Parameter("accel_y", "m/s^2", "reading less truth"),
            Parameter("accel_z", "m/s^2", "reading less truth"),
        ),
    ),
    "sensor_latency": SensorEffect(
        "a stream shows what was so long ago",
        tuple(Parameter(topic, "s", f"of the {topic}", 0.0, "not negative") for topic in LATE_TOPICS),
    ),
}
OFFSET, SINE, COSINE, PRESSURE, DRIFT, GYRO, ACCELERATION = 0, 1, 2, 3, 4, 5, 6
ERROR_COLUMNS: dict[str, int] = {
    f"{effect}.{parameter.name}": column
    for column, (effect, parameter) in enumerate(
        (effect, parameter)
        for effect, described in SENSOR_EFFECTS.items()
        if effect != "sensor_latency"
        for parameter in described.parameters
    )
}


class Faults(NamedTuple):
    """What is wrong with the instruments, with the leading axis (robots,)."""

    error: Floats  # (robots, columns of ERROR_COLUMNS), SI units
    latency: Floats  # (robots, LATE_TOPICS) [s]


@kernel
def compass_error(yaw: float, error: Floats) -> float:
    """Reading less heading [rad] at a heading [rad]; `error` by ERROR_COLUMNS."""
    sine, cosine = sine_cosine(yaw)
    total: float = error[OFFSET] + error[SINE] * sine + error[COSINE] * cosine
    return total


@kernel
def pressure_error(time: float, error: Floats) -> float:
    """Reading less pressure [Pa] at a time [s]; `error` by ERROR_COLUMNS."""
    total: float = error[PRESSURE] + error[DRIFT] * time
    return total


@kernel
def add_errors(state: Floats, time: float, error: Floats, readings: Readings) -> None:
    """Change the readings of all robots of `state` (runs, robots, columns) by their errors (robots, columns)."""
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            own = error[robot]
            shown = readings.compass[run, robot] + compass_error(state[run, robot, YAW], own)
            readings.compass[run, robot] = wrap_angle(shown)
            readings.pressure[run, robot] += pressure_error(time, own)
            readings.angular_rate[run, robot, 2] += own[GYRO]
            for axis in range(3):
                readings.specific_force[run, robot, axis] += own[ACCELERATION + axis]
