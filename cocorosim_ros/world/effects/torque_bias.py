"""A constant yaw torque: a bent fin, a keel that is not straight."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import TURN
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def torque_bias(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the torque."""
    (torque,) = unpack(parameters, 1)
    total[3] += torque


TORQUE_BIAS = Effect(
    summary="constant yaw torque",
    equation="N = const",
    wrench=torque_bias,
    parameters=(
        Number(
            "torque",
            "N m",
            "counter-clockwise positive",
            gives="N m",
            other_form=0.03,  # a torque that differs from place to place, as a trim of the buoyancy does
            search=Strength(large=1e-5),
            example=Example(2e-6, "straight run"),
        ),
    ),
    search=Search(channel="yaw", group=TURN, manoeuvre="thrust_staircase"),
    check="A bent fin, a thruster mounted askew, or a keel: let the robot coast straight on.",
)
