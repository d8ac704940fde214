"""The same velocity everywhere and always: (x, y)."""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.water.current import Current


@kernel
def uniform(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the constant velocity x, y [m/s; world]."""
    x, y = unpack(parameters, 2)
    total[0] += x
    total[1] += y


def fastest(parameters: Floats, size: tuple[float, float, float]) -> float:
    """The speed [m/s] itself."""
    x, y = parameters
    return math.hypot(x, y)


UNIFORM = Current(
    summary="the same velocity everywhere",
    velocity=uniform,
    parameters=("x", "y"),
    fastest=fastest,
)
