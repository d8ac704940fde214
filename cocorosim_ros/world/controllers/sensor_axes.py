"""Where the blue-light sensors of a robot look."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor, Vector3, unit_vector


def cone_axis(sensor: BlueLightSensor, offset: float = 0.0) -> Vector3:
    """Unit vector [body] of a sensor's axis, turned by `offset` [rad] in azimuth."""
    return unit_vector(sensor.azimuth + offset, sensor.elevation)
