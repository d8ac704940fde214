"""A pressure sensor that is wrong by a factor below the surface: shown = surface + gain * (pressure - surface).

Source: span error of a transducer; IEC 61298-2:2008, Tests under reference conditions.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown(value: float, truth: float, stamp: float, gain: float) -> float:
    """Absolute pressure [Pa] in place of `value`."""
    pressure: float = value + (gain - 1.0) * (value - SURFACE_PRESSURE)
    return pressure


@kernel
def slope(row: Floats, gain: float) -> float:
    """Derivative of the pressure that is shown by the true one."""
    return gain


PRESSURE_GAIN = SensorError(
    summary="pressure reading that is wrong by a factor below the surface",
    equation="reading = surface + gain * (pressure - surface)",
    parameters=(
        Number(
            "gain",
            "1",
            "overpressure as read over overpressure",
            1.0,
            "positive",
            multiplies="Pa",
            gives="Pa",
            search=Strength(large=0.05),
            example=Example(1.02, "plumb line"),
        ),
    ),
    sensor="pressure",
    changes=(Change("pressure", ("gain",), shown, slope),),
    against="z",
    # A factory sets it; a camera's scale and a mounting's offset are set on site. Four to one: chosen, not measured.
    search=Search(prior_nats=1.4, channel="pressure", group="pressure", topic="pressure", manoeuvre="surface_touch"),
    check="Lower the sensor by a known length, and compare what it shows at both ends; sea water weighs 2.5 % more "
    "than fresh, see `water_density` in the platform's file.",
)
