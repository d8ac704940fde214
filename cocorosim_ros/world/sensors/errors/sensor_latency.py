"""A stream that comes late: what it shows at t was at t - latency. Simulated in sensors.latency."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.sensor_error import SensorError

STREAMS = tuple(topic for topic, sensor in SENSORS.items() if sensor.kinds)
"""The topics that a diagnosis reads, each of which may be late or have a clock of its own."""
LATE_TOPICS = tuple(topic for topic in STREAMS if SENSORS[topic].fields)
"""Those whose latency a simulation has."""


def _whose(topic: str) -> str:
    return f"of the {topic}" if topic in LATE_TOPICS else "of the camera's poses"


SENSOR_LATENCY = SensorError(
    summary="a stream shows what was so long ago",
    parameters=tuple(Parameter(topic, "s", _whose(topic), 0.0, "not negative") for topic in STREAMS),
)
