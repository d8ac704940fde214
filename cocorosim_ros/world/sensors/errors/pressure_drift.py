"""A pressure sensor that drifts evenly: shown = pressure + rate t."""

from __future__ import annotations

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError


@kernel
def shown(value: float, truth: float, stamp: float, rate: float) -> float:
    """Pressure [Pa] in place of `value`."""
    return value + rate * stamp


PRESSURE_DRIFT = SensorError(
    summary="the reading of the pressure sensor drifts",
    parameters=(Parameter("rate", "Pa/s", "change of the reading in time"),),
    sensor="pressure",
    changes=(Change("pressure", ("rate",), shown),),
)
