"""A pressure sensor that shows too much, or, with a negative number, too little: shown = pressure + offset."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, added

PRESSURE_OFFSET = SensorError(
    summary="the pressure sensor shows too much",
    parameters=(Parameter("offset", "Pa", "reading less truth"),),
    sensor="pressure",
    changes=(Change("pressure", ("offset",), added),),
)
