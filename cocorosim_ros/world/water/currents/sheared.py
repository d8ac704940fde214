"""Velocity that changes linearly with place: u = x + dx_dy Y + dx_dz Z, v = y + dy_dx X + dy_dz Z.

X, Y, Z are the place [m; world], counted from the world's origin (the surface over the centre of the tank). Free of
divergence for every choice of the gradients.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.water.current import Current


@kernel
def sheared(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the velocity at the origin [m/s; world] and what the four gradients [1/s] add at `place`."""
    x, y, dx_dy, dx_dz, dy_dx, dy_dz = unpack(parameters, 6)
    total[0] += x + dx_dy * place[1] + dx_dz * place[2]
    total[1] += y + dy_dx * place[0] + dy_dz * place[2]


def fastest(parameters: Floats, size: tuple[float, float, float]) -> float:
    """The speed [m/s] at the corner of the tank where all gradients add up."""
    x, y, dx_dy, dx_dz, dy_dx, dy_dz = parameters
    along = abs(x) + abs(dx_dy) * 0.5 * size[1] + abs(dx_dz) * size[2]
    across = abs(y) + abs(dy_dx) * 0.5 * size[0] + abs(dy_dz) * size[2]
    return math.hypot(along, across)


SHEARED = Current(
    summary="velocity that changes linearly with place",
    velocity=sheared,
    parameters=("x", "y", "dx_dy", "dx_dz", "dy_dx", "dy_dz"),
    fastest=fastest,
)
