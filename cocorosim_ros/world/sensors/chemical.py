"""Chemical sensor: the concentration of the plume's substance at the robot's centre, exact and without delay."""

from __future__ import annotations

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor import Column, Field, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight


@kernel
def measure(sight: Sight) -> float:
    """Concentration [kg/m^3]."""
    return sight.concentration


CHEMICAL = Sensor(
    topic="concentration",
    message="cocorosim_msgs/msg/Concentration",
    meaning="how much of the plume's substance the water holds, where the controller asks for it",
    layout=fixed("concentration"),
    fields=(Field("concentration", "kg/m^3", channels={"concentration": None}),),
    measure=measure,
    asked=True,
    columns=(Column("concentration", "concentration", "kg/m^3"), Column("variance", "variance", "(kg/m^3)^2")),
)
