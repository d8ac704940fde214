"""A pressure sensor that drifts evenly: shown = pressure + rate t."""

from __future__ import annotations

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown(value: float, truth: float, stamp: float, rate: float) -> float:
    """Pressure [Pa] in place of `value`."""
    return value + rate * stamp


PRESSURE_DRIFT = SensorError(
    summary="pressure reading that drifts",
    equation="reading = pressure",
    parameters=(
        Number(
            "rate",
            "Pa/s",
            "change of the reading in time",
            multiplies="s",
            gives="Pa",
            part=" + rate t",
            search=Strength(large=0.7),
            example=Example(0.1, "reading before and after"),
        ),
    ),
    sensor="pressure",
    changes=(Change("pressure", ("rate",), shown),),
    beside=("pressure_offset",),
    search=Search(channel="pressure", group="pressure", topic="pressure", manoeuvre="surface_touch"),
    check="Read the sensor at the surface before and after; note the air pressure.",
)
