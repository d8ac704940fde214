"""Drag in proportion to speed: F = -d v along each body axis, N = -d r.

At the Reynolds numbers of small robots (below 1e4) friction is a part of the drag that no quadratic law has.
Source: Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2021), section 6.4.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def linear_drag(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the drag at the speed through the water."""
    for axis in range(4):
        total[axis] -= parameters[axis] * relative[axis]


LINEAR_DRAG = Effect(
    summary="drag in proportion to speed",
    wrench=linear_drag,
    parameters=(
        Parameter("surge", "N s/m", "force per speed forwards"),
        Parameter("sway", "N s/m", "force per speed sideways"),
        Parameter("heave", "N s/m", "force per speed upwards"),
        Parameter("yaw", "N m s", "moment per yaw rate"),
    ),
)
