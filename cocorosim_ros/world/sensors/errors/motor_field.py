"""A compass that the current of the motors turns: shown = yaw + field * (sum of |thrust| / sum of full thrust).

Assumes: a field in proportion to what all motors give, each by its own amount, that turns the reading by the same angle
at every heading.
Source: interference of motors with a compass, in proportion to throttle or current; ArduPilot, Copter documentation,
Magnetic Interference, CompassMot.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.motors import Motors, motor_share
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def shown(value: float, truth: float, stamp: float, row: Floats, motors: Motors, field: float) -> float:
    """Heading [rad] in place of `value`."""
    if field == 0.0:  # as nearly always
        return value
    heading: float = value + field * motor_share(row, motors)
    return heading


MOTOR_FIELD = SensorError(
    summary="compass that the motors disturb",
    equation="reading = yaw + field * |thrust| / full thrust",
    parameters=(
        Number(
            "field",
            "rad",
            "error of the heading at full thrust of all motors",
            gives="rad",
            other_form=0.08,  # motors that are not equally near to the compass
            search=Strength(large=0.085),
            example=Example(0.05, "motors on and off"),
        ),
    ),
    sensor="compass",
    changes=(Change("compass", ("field",), shown, takes=("row", "motors")),),
    against="|thrust|",
    needs=("thrusters",),
    search=Search(channel="compass", group=COURSE, topic="compass", manoeuvre="thrust_staircase"),
    check="Hold the vehicle still and run the motors up and down: the heading must not move. Lay their cables apart.",
)
