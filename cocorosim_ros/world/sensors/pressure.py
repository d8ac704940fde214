"""Pressure: the weight of air and water above, P = 101325 Pa - rho g z.

Source: hydrostatics; the constants are the contract's.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.influences import MOTORS, PUMP
from cocorosim_ros.world.sensors.pose import Rates, When, height
from cocorosim_ros.world.sensors.sensor import Column, Field, Kind, MostError, Recorded, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.blocks import VW, VZ


@kernel
def absolute_pressure(z: float, weight: float) -> float:
    """Absolute pressure [Pa] at height z [m; world] in water of this weight, density times gravity [Pa/m]."""
    return SURFACE_PRESSURE - weight * z


@kernel
def measure(sight: Sight) -> float:
    """Absolute pressure [Pa] in the water by which the sensor is calibrated."""
    weight = sight.instruments.water_density[sight.robot] * sight.instruments.gravity[sight.robot]
    shown: float = absolute_pressure(sight.row[Z], weight)
    return shown


@kernel
def _foresee(when: When, row: Floats, rates: Rates, water: Floats, weight: float) -> float:
    shown: float = absolute_pressure(height(when, row, rates, water), weight)
    return shown


@kernel
def _sensitivity(after: float, row: Floats, slope: float, rates: Floats, seen: Floats, weight: float) -> None:
    seen[VZ], seen[VW] = -slope * weight, -slope * weight * after


PRESSURE = Sensor(
    topic="pressure",
    message="sensor_msgs/msg/FluidPressure",
    meaning="absolute pressure: 101325 Pa at the surface, and per metre of depth what water weighs (fresh: 9810 Pa)",
    layout=fixed("fluid_pressure"),
    fields=(Field("pressure", "Pa", channels={"pressure": None}),),
    measure=measure,
    optional=False,
    for_all=True,
    columns=(Column("pressure", "fluid_pressure", "Pa"), Column("variance", "variance", "Pa^2")),
    kinds=(
        Kind("pressure", "pressure", "Pa", _foresee, _sensitivity, ("pressure", None), upright=True, by_weight=True,
             noise_words="a reading of the pressure",
             words="the pressure",
             least_noise=1.0, least_motion=50.0, large_error=200.0,
             error_follows=(*MOTORS, *PUMP, "x", "y", "u", "v", "r", "speed", "u*u", "speed*speed", "z*z", "r*r",
                            "|w|", "|w|*w", "t*t"),
             shows=("z", "w"),
             most_error=MostError(2000.0, 0.1)),  # weather of a day; a gauge that is ten per cent off is broken
    ),
    recorded=Recorded(2, lambda numbers: numbers[:, :1], drawn="pressure", late_with="w"),
)  # fmt: skip
