"""A speed log that is wrong by a factor along all axes: shown = scale * speed.

Source: a Doppler log takes a speed of sound, and its speeds go with it; RD Instruments, Acoustic Doppler Current
Profiler: Principles of Operation, A Practical Primer (1996).
"""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, multiplied, multiplied_slope
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import MEASURE
from cocorosim_ros.world.terms.search import Search, Strength


def scaled_log(topic: str, summary: str, speed: str) -> SensorError:
    """The error of the log that publishes `topic`; speed: what it measures, in words."""
    return SensorError(
        summary=summary,
        equation="reading = scale * speed",
        parameters=(
            Number(
                "scale",
                "1",
                f"speed as read over {speed}",
                1.0,
                "positive",
                multiplies="m/s",
                gives="m/s",
                search=Strength(large=0.05),
                example=Example(0.98, "measured mile"),
            ),
        ),
        sensor=topic,
        changes=tuple(Change(f"{topic}_{axis}", ("scale",), multiplied, multiplied_slope) for axis in "uvw"),
        against="u",
        search=Search(channel=topic, group=MEASURE, topic=topic, manoeuvre="four_headings"),
        check="Run a measured distance there and back, and compare it with the log; check its speed of sound.",
    )


SPEED_LOG_SCALE = scaled_log("velocity", "speed log that is wrong by a factor", "speed through the water")
