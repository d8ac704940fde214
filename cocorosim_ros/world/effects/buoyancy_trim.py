"""A weight that differs from the buoyancy, beyond what the platform says."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def buoyancy_trim(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force."""
    total[2] += parameters[0]


BUOYANCY_TRIM = Effect(
    summary="net weight or buoyancy",
    wrench=buoyancy_trim,
    parameters=(Parameter("force", "N", "up positive"),),
)
