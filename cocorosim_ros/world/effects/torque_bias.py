"""A constant yaw torque: a bent fin, a keel that is not straight."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def torque_bias(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the torque."""
    total[3] += parameters[0]


TORQUE_BIAS = Effect(
    summary="constant yaw torque",
    wrench=torque_bias,
    parameters=(Parameter("torque", "N m", "counter-clockwise positive"),),
)
