"""A steady current that this robot feels: the velocity (x, y) of the water.

The velocity itself is that of environment.currents.uniform.
"""

from __future__ import annotations

from cocorosim_ros.environment.currents.uniform import uniform
from cocorosim_ros.physics.effect import Effect, Parameter

STEADY_CURRENT = Effect(
    summary="the same velocity of the water everywhere and always",
    water=uniform,
    parameters=(
        Parameter("x", "m/s", "velocity along x of the world"),
        Parameter("y", "m/s", "velocity along y of the world"),
    ),
)
