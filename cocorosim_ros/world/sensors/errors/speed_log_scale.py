"""A speed log that is wrong by a factor along all axes: shown = scale * speed.

Source: a Doppler log takes a speed of sound, and its speeds go with it; RD Instruments, Acoustic Doppler Current
Profiler: Principles of Operation, A Practical Primer (1996).
"""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, multiplied, multiplied_slope
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import MEASURE
from cocorosim_ros.world.terms.search import Search, Strength

SPEED_LOG_SCALE = SensorError(
    summary="speed log that is wrong by a factor",
    equation="reading = scale * speed",
    parameters=(
        Number(
            "scale",
            "1",
            "speed as read over speed through the water",
            1.0,
            "positive",
            multiplies="m/s",
            gives="m/s",
            search=Strength(large=0.05),
            example=Example(0.98, "measured mile"),
        ),
    ),
    sensor="velocity",
    changes=tuple(
        Change(kind, ("scale",), multiplied, multiplied_slope) for kind in ("velocity_u", "velocity_v", "velocity_w")
    ),
    against="u",
    search=Search(channel="velocity", group=MEASURE, topic="velocity", manoeuvre="four_headings"),
    check="Run a measured distance there and back, and compare it with the log; check its speed of sound.",
)
