"""Weight and buoyancy of the hull at the pump's neutral position: Z = (rho V - m) g.

Assumes: fully submerged, water of one density.
Source: Read et al. 2013, equation (4), with up positive.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Number


@kernel
def net_buoyancy(row: Floats, relative: Floats, parameters: Floats, total: Floats) -> None:
    """Add the constant net buoyancy force, up positive."""
    (net_buoyancy,) = unpack(parameters, 1)
    total[2] += net_buoyancy


NET_BUOYANCY = Effect(
    summary="buoyancy less weight with the pump in its neutral position",
    equation="Z = (rho V - m) g",
    wrench=net_buoyancy,
    parameters=(Number("net_buoyancy", "N", "buoyancy less weight, up positive", gives="N"),),
)
