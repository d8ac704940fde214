"""Form drag: F = -k |v| v in the direction of motion, N = -k_r |r| r.

k = rho A Cd / 2 acts on the total speed, so the drag is the same in every direction.
Assumes: one drag coefficient at all speeds (the paper's choice; at Lily's Reynolds numbers it is not constant).
Source: Read et al. 2013, equations (1) and (3).
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Number


@kernel
def quadratic_drag(row: Floats, relative: Floats, parameters: Floats, total: Floats) -> None:
    """Add the drag on a body that moves through the water at `relative` (4,) [m/s, rad/s; body]."""
    drag, yaw_drag = unpack(parameters, 2)
    speed = math.sqrt(relative[0] * relative[0] + relative[1] * relative[1] + relative[2] * relative[2])
    for axis in range(3):
        total[axis] -= drag * speed * relative[axis]
    total[3] -= yaw_drag * abs(relative[3]) * relative[3]


QUADRATIC_DRAG = Effect(
    summary="drag against the total speed through the water",
    equation="F = -k U V, N = -k_r |r| r",
    wrench=quadratic_drag,
    parameters=(
        Number("drag", "kg/m", "rho A Cd / 2 for the total speed", multiplies="m^2/s^2", gives="N"),
        Number("yaw_drag", "N m s^2", "Cr, moment per squared yaw rate", multiplies="rad^2/s^2", gives="N m"),
    ),
)
