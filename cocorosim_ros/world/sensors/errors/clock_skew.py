"""A clock that runs wrong: stamp = t0 + (1 + skew) (t - t0). It is of a recording, not of a simulation."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors.errors.sensor_latency import STREAMS
from cocorosim_ros.world.sensors.sensor_error import SensorError

CLOCK_SKEW = SensorError(
    summary="the clock of a stream runs wrong",
    parameters=tuple(Parameter(topic, "s/s", f"of the {topic}'s clock") for topic in STREAMS),
)
