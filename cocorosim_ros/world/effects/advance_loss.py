"""Thrust that falls with speed: each thruster gives F (1 - slope a), a being the speed in the direction of its push.

A thruster that pulls backwards while the robot moves forwards gives more, one that follows the motion less.
Source: the straight part of a propeller's thrust coefficient over its advance ratio, Fossen (2021), section 9.2.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment, speed_along
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def advance_loss(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take away what each thruster loses at the speed through the water along its push."""
    (slope,) = unpack(parameters, 1)
    for actuator in range(moment.actuator_wrench.shape[0]):
        if moment.is_pump[actuator]:
            continue
        wrench = moment.actuator_wrench[actuator]
        lost = slope * abs(moment.force[actuator]) * speed_along(wrench, relative)
        for axis in range(4):
            total[axis] -= wrench[axis] * lost


ADVANCE_LOSS = Effect(
    summary="thrust that falls with speed",
    opposite="thrust that rises with speed",
    equation="T (1 - slope u)",
    wrench=advance_loss,
    parameters=(
        Number(
            "slope",
            "s/m",
            "fraction of the thrust lost per speed",
            multiplies="m/s",
            gives="1",
            search=Strength(large=3.0),
            example=Example(2.0, "coast-down and full speed"),
            other_form=0.1,  # thrust curves bend
        ),
    ),
    search=Search(channel="surge", group=DRAG, manoeuvre="coast_down"),
    check="Thrust at speed against thrust at rest: tow the robot, or compare coasting with driving.",
)
