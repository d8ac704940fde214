"""An eddy with a vertical axis (Lamb-Oseen): v_theta(r) = circulation / (2 pi r) (1 - exp(-r^2 / core^2)).

Within the core it turns like a solid body with the rate circulation / (2 pi core^2), far outside like a free vortex;
counter-clockwise for a positive circulation, the same at every depth, free of divergence.
Assumes: no decay; walls do not disturb it.
Source: Saffman, Vortex Dynamics (1992), section 13.1.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.water.current import Current

FASTEST = 0.6382  # of circulation / (2 pi core): maximum of (1 - exp(-s^2)) / s


@kernel
def vortex(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the velocity of an eddy around x, y [m; world] with circulation [m^2/s] and core radius [m]."""
    x, y, circulation, core = unpack(parameters, 4)
    east, north = place[0] - x, place[1] - y
    squared, core_squared = east * east + north * north, core * core
    turn = circulation / (2.0 * math.pi)
    # expm1 keeps the digits near the centre, where the quotient tends to 1 / core^2.
    rate = turn * (-math.expm1(-squared / core_squared) / squared) if squared > 0.0 else turn / core_squared
    total[0] -= rate * north
    total[1] += rate * east


def fastest(parameters: Floats, size: tuple[float, float, float]) -> float:
    """The speed [m/s] a little outside of the core, wherever the eddy is."""
    _, _, circulation, core = parameters
    return FASTEST * float(abs(circulation)) / (2.0 * math.pi * float(core))


VORTEX = Current(
    summary="an eddy with a vertical axis",
    velocity=vortex,
    parameters=("x", "y", "circulation", "core"),
    fastest=fastest,
)
