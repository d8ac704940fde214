"""A compass among iron and currents: shown = yaw + offset + sin * sin(yaw) + cos * cos(yaw).

Source: deviation of a ship's compass, coefficients A, B and C; National Geospatial-Intelligence Agency, Handbook of
Magnetic Compass Adjustment (2004), chapter IV.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown(value: float, yaw: float, stamp: float, offset: float, sin: float, cos: float) -> float:
    """Heading [rad] in place of `value`, with the same bits on every machine."""
    sine, cosine = sine_cosine(yaw)
    heading: float = value + offset + sin * sine + cos * cosine
    return heading


@kernel
def foreseen(value: float, yaw: float, stamp: float, offset: float, sin: float, cos: float) -> float:
    """`shown` with the sine and cosine of the mathematical library, which diagnoses have always used."""
    if sin == 0.0 and cos == 0.0:  # as nearly always
        return value + offset
    return value + offset + sin * math.sin(yaw) + cos * math.cos(yaw)


@kernel
def slope(row: Floats, offset: float, sin: float, cos: float) -> float:
    """Derivative of the heading that is shown by the yaw."""
    sine, cosine = sine_cosine(row[YAW])
    by_yaw: float = 1.0 + sin * cosine - cos * sine
    return by_yaw


COMPASS_DISTORTION = SensorError(
    summary="distorted compass",
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
            ("offset", "the same at every heading", 0.03, " + offset"),
            ("sin", "times the sine of the heading", 0.1, " + sin * sin(yaw)"),
            ("cos", "times the cosine of the heading", 0.0, " + cos * cos(yaw)"),
        )
    ),
    sensor="compass",
    changes=(Change("compass", ("offset", "sin", "cos"), shown, slope, foreseen),),
    against="yaw",
    search=Search(channel="compass", group=COURSE, topic="compass", manoeuvre="slow_turns"),
    check="Iron or currents near the compass: turn the robot slowly through full circles, both ways.",
)
