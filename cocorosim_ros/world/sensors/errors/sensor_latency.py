"""A stream that comes late: what it shows at t was at t - latency. Simulated in sensors.latency."""

from __future__ import annotations

from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.sensor_error import OfEveryStream, SensorError
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import LATE
from cocorosim_ros.world.terms.search import DELAYS, Search, Strength

CLOCK_TICK = 0.01  # s, a tenth of the filter's step: delays below, and skews that make less of it on average, are none
STREAMS = tuple(topic for topic, sensor in SENSORS.items() if sensor.kinds)
"""The topics that a diagnosis reads, each of which may be late or have a clock of its own."""
LATE_TOPICS = tuple(topic for topic in STREAMS if SENSORS[topic].fields)
"""Those whose latency a simulation has."""


def _whose(topic: str) -> str:
    return f"of the {topic}" if topic in LATE_TOPICS else "of the camera's poses"


def _search(topic: str) -> Search:
    # A pump that is late and a pressure reading that is late look alike.
    return Search(channel=topic, group=LATE, topic=topic, manoeuvre="steps", of_pump=topic == "pressure")


SENSOR_LATENCY = SensorError(
    summary="stream that comes late",
    equation="reading(t) = what was at t - latency",
    parameters=tuple(
        Number(
            topic,
            "s",
            _whose(topic),
            0.0,
            "not negative",
            gives="s",
            search=Strength(large=0.15, least=0.0, negligible=(-CLOCK_TICK, CLOCK_TICK), searched=DELAYS),
            example=Example(0.3, "light on command"),
        )
        for topic in STREAMS
    ),
    streams=OfEveryStream("latency", lambda topic: f"{topic} that comes late", _search),
    check="Filters and buffers between this sensor and its stamp; flash a light on command.",
)
