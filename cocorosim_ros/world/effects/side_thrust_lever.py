"""Thrust to the side that turns the vehicle: N = lever Y, Y being the sideways force of all thrusters.

The thrusters push in front of where the platform's file has them, or behind it where the lever is negative.
Source: moment of a force about the origin; Fossen (2021), section 9.4.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import TURN
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def side_thrust_lever(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the moment of the sideways thrust."""
    (lever,) = unpack(parameters, 1)
    total[3] += lever * moment.thrust[1]


SIDE_THRUST_LEVER = Effect(
    summary="sideways thrust that turns the vehicle",
    equation="N = lever * Y of the thrusters",
    wrench=side_thrust_lever,
    parameters=(
        Number(
            "lever",
            "m",
            "by which the sideways force acts in front of where the platform has it",
            multiplies="N",
            gives="N m",
            search=Strength(large=0.01),
            example=Example(0.005, "sideways run"),
        ),
    ),
    search=Search(channel="yaw", group=TURN, manoeuvre="thrust_staircase"),
    needs=("side_thrusters",),
    check="Push sideways alone and see whether the vehicle turns; measure where thrusters and mass are.",
)
