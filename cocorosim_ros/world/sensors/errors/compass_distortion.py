"""A compass among iron and currents: shown = yaw + offset + sin * sin(yaw) + cos * cos(yaw).

Source: deviation of a ship's compass, coefficients A, B and C; National Geospatial-Intelligence Agency, Handbook of
Magnetic Compass Adjustment (2004), chapter IV.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.state import YAW


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


NUMBERS = ("offset", "sin", "cos")
COMPASS_DISTORTION = SensorError(
    summary="the compass shows yaw + offset + sin * sin(yaw) + cos * cos(yaw)",
    parameters=(
        Parameter("offset", "rad", "the same at every heading"),
        Parameter("sin", "rad", "times the sine of the heading"),
        Parameter("cos", "rad", "times the cosine of the heading"),
    ),
    sensor="compass",
    changes=(Change("compass", NUMBERS, shown, slope, foreseen),),
    against="yaw",
)
