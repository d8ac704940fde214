"""Buoyancy that is lost with depth, because the hull shrinks: Z = -gradient depth; none at the surface.

Assumes: it shrinks in proportion to the pressure, as a stiff hull does.
Source: Graver, Underwater Gliders (2005), section 4.1.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment

ATMOSPHERE = 10.33  # m of water that weigh as much as the air above


@kernel
def hull_compressibility(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the buoyancy that is lost."""
    depth = max(-row[Z], 0.0)
    total[2] -= parameters[0] * depth / (1.0 + parameters[1] * depth / ATMOSPHERE)


HULL_COMPRESSIBILITY = Effect(
    summary="buoyancy lost with depth",
    wrench=hull_compressibility,
    parameters=(
        Parameter("gradient", "N/m", "buoyancy lost per metre, at the surface, positive for a hull that shrinks"),
        Parameter("gas", "1", "0: an elastic hull, in proportion to depth; 1: a volume of gas, by Boyle's law"),
    ),
)
