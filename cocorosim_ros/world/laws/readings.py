"""READINGS: what a single reading can be of. The place in the table is the code that a law of readings carries."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.world.sensors import SENSORS


class Reading(NamedTuple):
    """One number that an instrument or the camera shows."""

    name: str
    topic: str
    unit: str
    is_angle: bool  # so that a full turn is no difference


READINGS: tuple[Reading, ...] = tuple(
    Reading(kind.name, sensor.topic, kind.unit, kind.angle) for sensor in SENSORS.values() for kind in sensor.kinds
)
READING_CODE = {reading.name: code for code, reading in enumerate(READINGS)}
READING = {reading.name: reading for reading in READINGS}


def readings_of(topic: str) -> tuple[str, ...]:
    """Names of the readings of a topic, in the order of the table."""
    return tuple(reading.name for reading in READINGS if reading.topic == topic)
