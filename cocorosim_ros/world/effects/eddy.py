"""An eddy with a vertical axis, as this robot feels it: the water turns about a place.

The velocity itself is that of currents.vortex.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.water.currents.vortex import vortex

EDDY = Effect(
    summary="water that turns about a place",
    water=vortex,
    parameters=(
        Parameter("x", "m", "place of the axis along x of the world"),
        Parameter("y", "m", "place of the axis along y of the world"),
        Parameter("circulation", "m^2/s", "around the whole of it, counter-clockwise positive"),
        Parameter("core", "m", "radius within which it turns like a solid body", 1.0, "positive", needed=True),
    ),
)
