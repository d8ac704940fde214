"""Force of the patch of water around the robot, and the yaw moment of its neighbours: the paper's force currents.

The four numbers change from tick to tick; the water of the simulation writes them (force_field.push).
Source: Read et al. 2013, section 3.1.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.effect import Effect, Number


@kernel
def patch_force(row: Floats, relative: Floats, parameters: Floats, total: Floats) -> None:
    """Add the force (3,) [N; world], turned into the body, and the moment [N m]."""
    patch_force_x, patch_force_y, patch_force_z, patch_moment = unpack(parameters, 4)
    sine, cosine = sine_cosine(row[YAW])
    total[0] += patch_force_x * cosine + patch_force_y * sine
    total[1] += patch_force_y * cosine - patch_force_x * sine
    total[2] += patch_force_z
    total[3] += patch_moment


PATCH_FORCE = Effect(
    summary="force and yaw moment of the patches of water around the robot",
    equation="F = force of the patch, N = moment of the patches around it",
    wrench=patch_force,
    parameters=(
        Number("patch_force_x", "N", "force of the robot's patch along x of the world", gives="N"),
        Number("patch_force_y", "N", "force of the robot's patch along y of the world", gives="N"),
        Number("patch_force_z", "N", "force of the robot's patch, up positive", gives="N"),
        Number("patch_moment", "N m", "yaw moment of the four patches around it", gives="N m"),
    ),
)
