"""A current that swings in time, as this robot feels it: (x, y) sin(2 pi t / period + phase).

The velocity itself is that of currents.tidal.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.water.currents.tidal import tidal

TIDAL_CURRENT = Effect(
    summary="velocity of the water that swings in time",
    water=tidal,
    parameters=(
        Parameter("x", "m/s", "amplitude along x of the world"),
        Parameter("y", "m/s", "amplitude along y of the world"),
        Parameter("period", "s", "time of one swing", 60.0, "positive", needed=True),
        Parameter("phase", "rad", "phase at time zero"),
    ),
)
