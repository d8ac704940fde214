"""Thrust that falls with speed: each thruster gives F (1 - slope a), a being the speed in the direction of its push.

A thruster that pulls backwards while the robot moves forwards gives more, one that follows the motion less.
Source: the straight part of a propeller's thrust coefficient over its advance ratio, Fossen (2021), section 9.2.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def advance_loss(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take away what each thruster loses at the speed through the water along its push."""
    for actuator in range(moment.actuator_wrench.shape[0]):
        if moment.is_pump[actuator]:
            continue
        wrench, advance = moment.actuator_wrench[actuator], 0.0
        for axis in range(3):
            advance += wrench[axis] * relative[axis]
        lost = parameters[0] * abs(moment.force[actuator]) * advance
        for axis in range(4):
            total[axis] -= wrench[axis] * lost


ADVANCE_LOSS = Effect(
    summary="thrust falls with speed",
    wrench=advance_loss,
    parameters=(Parameter("slope", "s/m", "fraction of the thrust lost per speed"),),
)
