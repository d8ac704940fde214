"""Compass: the heading, exact, in (-pi, pi].

Source: Read et al. 2013, section 2.1; its operating system returns the exact heading.
"""

from __future__ import annotations

from cocorosim_ros.foundation.compiling.angles import wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.influences import PLACE, PUMP, TURN
from cocorosim_ros.world.sensors.pose import by_heading, heading
from cocorosim_ros.world.sensors.sensor import Column, Field, Kind, MostError, Recorded, Sensor, fixed
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.state import YAW


@kernel
def measure(sight: Sight) -> float:
    """Heading [rad; world]."""
    shown: float = wrap_angle(sight.row[YAW])
    return shown


COMPASS = Sensor(
    topic="compass",
    message="cocorosim_msgs/msg/Compass",
    meaning="heading as the compass reports it",
    layout=fixed("heading"),
    fields=(Field("compass", "rad", angle=True, channels={"compass": None}),),
    measure=measure,
    optional=False,
    for_all=True,
    columns=(Column("heading", "heading", "rad"), Column("variance", "variance", "rad^2")),
    kinds=(
        Kind("compass", "heading", "rad", heading, by_heading, ("compass", None), angle=True,
             noise_words="a reading of the compass",
             words="the compass",
             least_noise=1e-3, least_motion=0.02, large_error=0.05,
             error_follows=("thrust", "yaw_command", *PUMP, *PLACE, "t", "u", "v", "w", "speed", "|r|", "|r|*r",
                            "|thrust|*sin_yaw", "|thrust|*cos_yaw"),
             most_error=MostError(0.5), shows=TURN),  # iron in the hull; more is another frame
    ),
    recorded=Recorded(2, lambda numbers: numbers[:, :1], drawn="compass", late_with="r"),
)  # fmt: skip
