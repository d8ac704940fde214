"""Where the blue-light sensors of a robot look."""

from __future__ import annotations

import math

from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor


def cone_axis(sensor: BlueLightSensor, offset: float = 0.0) -> tuple[float, float, float]:
    """Unit vector [body] of a sensor's axis, turned by `offset` [rad] in azimuth."""
    azimuth, level = sensor.azimuth + offset, math.cos(sensor.elevation)
    return level * math.cos(azimuth), level * math.sin(azimuth), math.sin(sensor.elevation)
