"""An eddy with a vertical axis, as this robot feels it: the water turns about a place.

The velocity itself is that of currents.vortex.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.water.currents.vortex import vortex

EDDY = Effect(
    summary="water that turns about a place",
    equation="V_c = circulation / (2 pi d) (1 - exp(-d^2 / core^2)) around (x, y) at the distance d",
    water=vortex,
    parameters=(
        Number("x", "m", "place of the axis along x of the world", gives="m", example=Example(0.4, "floats")),
        Number("y", "m", "place of the axis along y of the world", gives="m", example=Example(-0.3, "floats")),
        Number(
            "circulation",
            "m^2/s",
            "around the whole of it, counter-clockwise positive",
            multiplies="1/m",
            gives="m/s",
            example=Example(0.03, "floats"),
        ),
        Number(
            "core",
            "m",
            "radius within which it turns like a solid body",
            neutral=1.0,
            sign="positive",
            needed=True,
            gives="m",
            example=Example(0.6, "floats"),
        ),
    ),
)
