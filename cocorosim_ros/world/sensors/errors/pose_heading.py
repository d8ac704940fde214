"""A heading of the pose that is off by a constant: shown = yaw + offset; a marker or a pair of antennas put on askew.

It is of a recording, not of a simulation.
"""

from __future__ import annotations

from cocorosim_ros.world.sensors.sensor_error import Change, SensorError, added
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.search import Search, Strength

POSE_HEADING = SensorError(
    summary="heading of the pose that is off by an angle",
    equation="reading = yaw + offset",
    parameters=(
        Number(
            "offset",
            "rad",
            "heading as read less heading",
            gives="rad",
            search=Strength(large=0.085),
            example=Example(0.07, "straight run"),
        ),
    ),
    sensor="pose",
    changes=(Change("pose_yaw", ("offset",), added),),
    against="yaw",
    told_by=("zero_of_yaw",),
    search=Search(channel="pose", group=COURSE, topic="pose", manoeuvre="reverse_steps"),
    check="How the marker, or the line between the antennas, lies on the hull: sight along it.",
)
