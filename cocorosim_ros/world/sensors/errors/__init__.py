"""ERRORS: how instruments, cameras, clocks and the way of a command are wrong by a law, by the catalogue's names."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.errors.camera_scale import CAMERA_SCALE
from cocorosim_ros.world.sensors.errors.clock_skew import CLOCK_SKEW
from cocorosim_ros.world.sensors.errors.command_delay import COMMAND_DELAY
from cocorosim_ros.world.sensors.errors.compass_distortion import COMPASS_DISTORTION
from cocorosim_ros.world.sensors.errors.frame_mixup import FRAME_MIXUP
from cocorosim_ros.world.sensors.errors.ground_log_lever import GROUND_LOG_LEVER
from cocorosim_ros.world.sensors.errors.ground_log_misalignment import GROUND_LOG_MISALIGNMENT
from cocorosim_ros.world.sensors.errors.ground_log_scale import GROUND_LOG_SCALE
from cocorosim_ros.world.sensors.errors.gyro_scale import GYRO_SCALE
from cocorosim_ros.world.sensors.errors.imu_bias import IMU_BIAS
from cocorosim_ros.world.sensors.errors.motor_field import MOTOR_FIELD
from cocorosim_ros.world.sensors.errors.pose_heading import POSE_HEADING
from cocorosim_ros.world.sensors.errors.pose_lever import POSE_LEVER
from cocorosim_ros.world.sensors.errors.pressure_drift import PRESSURE_DRIFT
from cocorosim_ros.world.sensors.errors.pressure_gain import PRESSURE_GAIN
from cocorosim_ros.world.sensors.errors.pressure_offset import PRESSURE_OFFSET
from cocorosim_ros.world.sensors.errors.sensor_latency import LATE_TOPICS, SENSOR_LATENCY
from cocorosim_ros.world.sensors.errors.soft_iron import SOFT_IRON
from cocorosim_ros.world.sensors.errors.speed_log_lever import SPEED_LOG_LEVER
from cocorosim_ros.world.sensors.errors.speed_log_misalignment import SPEED_LOG_MISALIGNMENT
from cocorosim_ros.world.sensors.errors.speed_log_scale import SPEED_LOG_SCALE
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError

ERRORS: dict[str, SensorError] = {
    "compass_distortion": COMPASS_DISTORTION,
    "pressure_gain": PRESSURE_GAIN,
    "pressure_offset": PRESSURE_OFFSET,
    "pressure_drift": PRESSURE_DRIFT,
    "gyro_scale": GYRO_SCALE,
    "imu_bias": IMU_BIAS,
    "pose_lever": POSE_LEVER,
    "pose_heading": POSE_HEADING,
    "camera_scale": CAMERA_SCALE,
    "motor_field": MOTOR_FIELD,
    "soft_iron": SOFT_IRON,
    "speed_log_misalignment": SPEED_LOG_MISALIGNMENT,
    "speed_log_scale": SPEED_LOG_SCALE,
    "speed_log_lever": SPEED_LOG_LEVER,
    "ground_log_misalignment": GROUND_LOG_MISALIGNMENT,
    "ground_log_scale": GROUND_LOG_SCALE,
    "ground_log_lever": GROUND_LOG_LEVER,
    "sensor_latency": SENSOR_LATENCY,
    "clock_skew": CLOCK_SKEW,
    "frame_mixup": FRAME_MIXUP,
    "command_delay": COMMAND_DELAY,
}
"""Every error; those of one number act in this order."""

ERROR_COLUMNS: dict[str, int] = {
    name: column
    for column, name in enumerate(
        f"{name}.{part.name}" for name, error in ERRORS.items() if error.changes for part in error.parameters
    )
}
"""Where the numbers of errors that change readings stand in a row."""
NEUTRAL = tuple(part.neutral for error in ERRORS.values() if error.changes for part in error.parameters)
"""What those numbers are where nothing is wrong."""

SEEN_OTHERWISE = frozenset(
    f"{name}.{number}"
    for name, error in ERRORS.items()
    for change in error.changes
    if change.slope is not None or change.aside is not None
    for number in change.numbers
)
"""Names of the numbers by which a reading depends otherwise on the state, not by an amount on top alone."""


def changes_of(kind: str) -> list[tuple[Change, list[int]]]:
    """How errors change the numbers of this kind, in their order, each with the columns of its numbers."""
    return [
        (change, [ERROR_COLUMNS[f"{name}.{number}"] for number in change.numbers])
        for name, error in ERRORS.items()
        for change in error.changes
        if change.kind == kind
    ]


def is_simulated(name: str, parameter: Parameter) -> bool:
    """Whether a simulation has this number of an error, which is then of the robot and not of the recording."""
    if ERRORS[name].changes:
        return any(KINDS[change.kind].place for change in ERRORS[name].changes if parameter.name in change.numbers)
    return name == "command_delay" or (name == "sensor_latency" and parameter.name in LATE_TOPICS)


def units_of(name: str) -> dict[str, str]:
    """The units of an error's numbers, by the names that they have where the stream is known, if it is of one."""
    error = ERRORS[name]
    if error.streams is not None:
        return {error.streams.number: error.parameters[0].unit}
    described = [error, *(ERRORS[each] for each in error.beside)]
    return {part.name: part.unit for each in described for part in each.parameters}
