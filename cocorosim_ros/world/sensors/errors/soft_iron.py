"""A compass beside iron that the earth's field magnetises: shown = yaw + sin_2 * sin(2 yaw) + cos_2 * cos(2 yaw).

Source: deviation of a ship's compass, coefficients D and E, of iron that is magnetised by induction; National
Geospatial-Intelligence Agency, Handbook of Magnetic Compass Adjustment (2004), chapter IV.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.state import YAW, YAW_RATE
from cocorosim_ros.world.terms.blocks import HR, HYAW
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown(value: float, yaw: float, stamp: float, sin_2: float, cos_2: float) -> float:
    """Heading [rad] in place of `value`, with the same bits on every machine."""
    sine, cosine = sine_cosine(2.0 * yaw)
    heading: float = value + sin_2 * sine + cos_2 * cosine
    return heading


@kernel
def foreseen(value: float, yaw: float, stamp: float, sin_2: float, cos_2: float) -> float:
    """`shown` with the sine and cosine of the mathematical library."""
    if sin_2 == 0.0 and cos_2 == 0.0:  # as nearly always
        return value
    return value + sin_2 * math.sin(2.0 * yaw) + cos_2 * math.cos(2.0 * yaw)


@kernel
def by_turn(after: float, row: Floats, slope: float, seen: Floats, sin_2: float, cos_2: float) -> None:
    """Add the derivative of the heading that is shown by yaw and yaw rate."""
    if sin_2 == 0.0 and cos_2 == 0.0:
        return
    sine, cosine = sine_cosine(2.0 * (row[YAW] + after * row[YAW_RATE]))
    by_yaw = 2.0 * slope * (sin_2 * cosine - cos_2 * sine)
    seen[HYAW] += by_yaw
    seen[HR] += by_yaw * after


SOFT_IRON = SensorError(
    summary="soft iron near the compass",
    equation="reading = yaw",
    parameters=tuple(
        Number(
            name,
            "rad",
            meaning,
            gives="rad",
            search=Strength(large=0.085),
            example=Example(value, "full turn"),
            part=part,
        )
        for name, meaning, value, part in (
            ("sin_2", "times the sine of twice the heading", 0.05, " + sin_2 * sin(2 yaw)"),
            ("cos_2", "times the cosine of twice the heading", 0.0, " + cos_2 * cos(2 yaw)"),
        )
    ),
    sensor="compass",
    changes=(Change("compass", ("sin_2", "cos_2"), shown, foreseen=foreseen, aside=by_turn),),
    against="yaw",
    search=Search(channel="compass", group=COURSE, topic="compass", manoeuvre="slow_turns"),
    check="Iron near the compass that is no magnet, such as ballast or a frame: turn the robot slowly through full "
    "circles, both ways.",
)
