"""What force currents do to a robot: its own patch pushes it, the four patches around it turn it.

N = lever * (Fy[+x] - Fy[-x] - Fx[+y] + Fx[-y]), counter-clockwise positive: each neighbour's force across the line to
it, times a lever. It is figure 2c of the paper, whose torque (B - C) + (D - E) is clockwise and states no lever. With
a lever of one patch it is the moment of the four forces about the robot's centre where they stand. A neighbour that is
not water counts as none.
Source: Read et al. 2013, section 3.1 and figure 2c.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import X, Y, Z
from cocorosim_ros.world.water.patches import Patches, is_water, nearest_patch


@kernel
def _force_at(field: Floats, patches: Patches, axis: int, k: int, j: int, i: int) -> float:
    force: float = field[axis, k, j, i] if is_water(patches, k, j, i) else 0.0
    return force


@kernel
def push_robots(field: Floats, patches: Patches, lever: float, state: Floats, push: Floats) -> None:
    """Write force x, y, z [N; world] and yaw moment [N m] on every robot of one run into `push` (robots, 4)."""
    for robot in range(state.shape[0]):
        k, j, i = nearest_patch(patches, state[robot, X], state[robot, Y], state[robot, Z])
        for axis in range(3):
            push[robot, axis] = field[axis, k, j, i]
        east = _force_at(field, patches, 1, k, j, i + 1) - _force_at(field, patches, 1, k, j, i - 1)
        north = _force_at(field, patches, 0, k, j + 1, i) - _force_at(field, patches, 0, k, j - 1, i)
        push[robot, 3] = lever * (east - north)
