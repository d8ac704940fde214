"""A current that changes linearly with place, as this robot feels it.

The velocity itself is that of currents.sheared.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.water.currents.sheared import sheared

SHEARED_CURRENT = Effect(
    summary="velocity of the water that changes with place",
    water=sheared,
    parameters=(
        Parameter("x", "m/s", "velocity along x at the world's origin"),
        Parameter("y", "m/s", "velocity along y at the world's origin"),
        Parameter("dx_dy", "1/s", "change of x along y"),
        Parameter("dx_dz", "1/s", "change of x upwards"),
        Parameter("dy_dx", "1/s", "change of y along x"),
        Parameter("dy_dz", "1/s", "change of y upwards"),
    ),
)
