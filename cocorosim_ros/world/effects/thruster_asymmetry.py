"""Left and right thrusters that differ in strength: 1 - d/2 on the left, 1 + d/2 on the right.

Right is what turns the robot counter-clockwise when it pushes forwards. Thrusters without a lever stay as they are.
"""

from __future__ import annotations

import math
from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.curve import is_thruster
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import TURN
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def thruster_asymmetry(share: Floats, fitting: Any, time: float, parameters: Floats) -> None:
    """Make one side stronger and the other weaker."""
    (difference,) = unpack(parameters, 1)
    for actuator in range(share.shape[0]):
        lever = fitting.lever[actuator]
        if is_thruster(fitting.is_pump, fitting.curve, actuator) and lever != 0.0:
            share[actuator] *= 1.0 + math.copysign(0.5 * difference, lever * difference)


THRUSTER_ASYMMETRY = Effect(
    summary="left and right thrusters that differ",
    equation="T_right / T_left = (1 + d/2) / (1 - d/2)",
    thrust=thruster_asymmetry,
    parameters=(
        Number(
            "difference",
            "1",
            "right less left, over their mean",
            gives="1",
            search=Strength(large=0.06),
            between=(-2.0, 2.0),  # one of the two gives nothing
            example=Example(0.03, "straight run"),
        ),
    ),
    search=Search(channel="yaw", group=TURN, manoeuvre="thrust_staircase"),
    check="Weigh the thrust of both thrusters at the same command; look for a damaged propeller.",
)
