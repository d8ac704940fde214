"""A pressure sensor that shows too much, or, with a negative number, too little: shown = pressure + offset."""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, added
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.search import Search, Strength

PRESSURE_OFFSET = SensorError(
    summary="pressure reading that is shifted",
    equation="reading = pressure",
    parameters=(
        Number(
            "offset",
            "Pa",
            "reading less truth",
            gives="Pa",
            part=" + offset",
            search=Strength(large=500.0),
            example=Example(120.0, "reading in air"),
        ),
    ),
    sensor="pressure",
    changes=(Change("pressure", ("offset",), added),),
    search=Search(channel="pressure", group="pressure", topic="pressure", manoeuvre="surface_touch"),
    check="Read the sensor at the surface.",
)
