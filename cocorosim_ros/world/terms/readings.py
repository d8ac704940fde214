"""READINGS: what a single reading can be of. The place in the table is the code that a law of readings carries."""

from __future__ import annotations

from typing import NamedTuple


class Reading(NamedTuple):
    """One number that an instrument or the camera shows."""

    name: str
    topic: str
    unit: str
    is_angle: bool = False  # so that a full turn is no difference


READINGS: tuple[Reading, ...] = (
    Reading("pose_x", "pose", "m"),
    Reading("pose_y", "pose", "m"),
    Reading("pose_z", "pose", "m"),
    Reading("pose_yaw", "pose", "rad", is_angle=True),
    Reading("compass", "compass", "rad", is_angle=True),
    Reading("pressure", "pressure", "Pa"),
    Reading("gyro_z", "imu", "rad/s"),
    Reading("accel_x", "imu", "m/s^2"),
    Reading("accel_y", "imu", "m/s^2"),
    Reading("accel_z", "imu", "m/s^2"),
    Reading("velocity_u", "velocity", "m/s"),
    Reading("velocity_v", "velocity", "m/s"),
    Reading("velocity_w", "velocity", "m/s"),
)
READING_CODE = {reading.name: code for code, reading in enumerate(READINGS)}
READING = {reading.name: reading for reading in READINGS}


def readings_of(topic: str) -> tuple[str, ...]:
    """Names of the readings of a topic, in the order of the table."""
    return tuple(reading.name for reading in READINGS if reading.topic == topic)
