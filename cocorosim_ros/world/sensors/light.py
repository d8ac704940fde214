"""Light sensor: the illuminance at the robot's centre, the same from all directions, exact."""

from __future__ import annotations

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor import Column, Field, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.state import X, Z
from cocorosim_ros.world.surroundings.lamps import illuminance_at


@kernel
def measure(sight: Sight) -> float:
    """Illuminance [lx]."""
    shown: float = illuminance_at(sight.lamps, sight.row[X : Z + 1])
    return shown


LIGHT = Sensor(
    topic="illuminance",
    message="sensor_msgs/msg/Illuminance",
    meaning="ambient light, where the controller asks for it",
    layout=fixed("illuminance"),
    fields=(Field("illuminance", "lx", channels={"illuminance": None}),),
    measure=measure,
    asked=True,
    columns=(Column("illuminance", "illuminance", "lx"), Column("variance", "variance", "lx^2")),
)
