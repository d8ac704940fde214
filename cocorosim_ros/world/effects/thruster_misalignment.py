"""Thrusters that push off their axis: the horizontal force of all is turned by an angle.

With a lever arm the sideways part turns the robot too: N = arm (sideways force). For thrusters that are turned where
they are mounted the arm is how far they sit in front of the centre, negative for a stern drive.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def thruster_misalignment(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the turned force of the thrusters less the straight one."""
    sine, cosine = sine_cosine(parameters[0])
    surge, sway = moment.thrust[0], moment.thrust[1]
    aside = surge * sine + sway * (cosine - 1.0)
    total[0] += surge * (cosine - 1.0) - sway * sine
    total[1] += aside
    total[3] += parameters[1] * aside


THRUSTER_MISALIGNMENT = Effect(
    summary="thrust direction off by an angle",
    wrench=thruster_misalignment,
    parameters=(
        Parameter("angle", "rad", "of the push, counter-clockwise positive"),
        Parameter("arm", "m", "yaw moment per sideways force"),
    ),
)
