"""A clock that runs wrong: stamp = t0 + (1 + skew) (t - t0). It is of a recording, not of a simulation."""

from __future__ import annotations

from cocorosim_ros.world.sensors.errors.sensor_latency import CLOCK_TICK, STREAMS
from cocorosim_ros.world.sensors.sensor_error import OfEveryStream, SensorError
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import LATE
from cocorosim_ros.world.terms.search import Search, Strength


def _search(topic: str) -> Search:
    return Search(channel="clock", group=LATE, topic=topic, manoeuvre="repeat_at_end", of_pump=topic == "pressure")


CLOCK_SKEW = SensorError(
    summary="clock of a stream that runs wrong",
    equation="stamp = t0 + (1 + skew) (t - t0)",
    parameters=tuple(
        Number(
            topic,
            "s/s",
            f"of the {topic}'s clock",
            multiplies="s",
            gives="s",
            search=Strength(large=5e-4, adds_up=2.0 * CLOCK_TICK),
            example=Example(1e-4, "one event seen twice"),
        )
        for topic in STREAMS
    ),
    streams=OfEveryStream("skew", lambda topic: f"clock of {topic} that runs wrong", _search),
    check="Synchronise the clocks, or note one event in both recordings at the start and at the end.",
)
