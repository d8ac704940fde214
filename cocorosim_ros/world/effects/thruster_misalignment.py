"""Thrusters that push off their axis: the horizontal force of all is turned by an angle.

With a lever arm the sideways part turns the robot too: N = arm (sideways force). For thrusters that are turned where
they are mounted the arm is how far they sit in front of the centre, negative for a stern drive.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import COURSE
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Search, Strength


@kernel
def thruster_misalignment(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the turned force of the thrusters less the straight one."""
    angle, arm = unpack(parameters, 2)
    sine, cosine = sine_cosine(angle)
    surge, sway = moment.thrust[0], moment.thrust[1]
    aside = surge * sine + sway * (cosine - 1.0)
    total[0] += surge * (cosine - 1.0) - sway * sine
    total[1] += aside
    total[3] += arm * aside


THRUSTER_MISALIGNMENT = Effect(
    summary="thrust beside the hull's axis",
    equation="thrust turned by an angle",
    wrench=thruster_misalignment,
    parameters=(
        Number(
            "angle",
            "rad",
            "of the push, counter-clockwise positive",
            gives="rad",
            other_form=0.06,  # flow around the hull turns a weak push more than a strong one
            search=Strength(large=0.08),
            between=(-math.pi, math.pi),
            example=Example(0.05, "straight run"),
        ),
        Number(
            "arm",
            "m",
            "yaw moment per sideways force",
            multiplies="N",
            gives="N m",
            search=Grid(lambda scene: [0.0, scene.arm], fixed=True),
            example=Example(-0.05, "where the thrusters sit"),
        ),
    ),
    search=Search(channel="sway", group=COURSE, manoeuvre="reverse_steps"),
    check="The axis of the thrusters against the axis of the hull, and of the camera's marker.",
)
