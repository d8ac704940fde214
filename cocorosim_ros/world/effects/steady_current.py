"""A steady current that this robot feels: the velocity (x, y) of the water.

The velocity itself is that of currents.uniform.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.water.currents.uniform import uniform

STEADY_CURRENT = Effect(
    summary="the same velocity of the water everywhere and always",
    water=uniform,
    parameters=(
        Parameter("x", "m/s", "velocity along x of the world"),
        Parameter("y", "m/s", "velocity along y of the world"),
    ),
)
