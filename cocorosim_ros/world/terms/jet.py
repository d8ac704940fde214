"""The jet of a thruster at the place of another one: how much of it is left there, and rows of numbers of such pairs.

Along the jet 0.75^((x / D)^(2/3)) is left at the distance x behind a propeller of the diameter D, across it
exp(-(a / b)^2) at the distance a from its axis, with the half-width b = D / 2 + 0.107 x.
Source: American Bureau of Shipping, Guide for Dynamic Positioning Systems (2013), section 8, thrusters in line, after
model tests of Lehn (1980): of two equal thrusts the second keeps 1 - 0.75^((x / D)^(2/3)); width of a round turbulent
jet: Fischer et al., Mixing in Inland and Coastal Waters (1979), chapter 9.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel

ON, ON_TURNED, BY, BY_TURNED, FROM_X, FROM_Y, FROM_Z, DIAMETER = range(8)
"""Columns of a pair: places among the actuators of the thruster in the jet and of that whose jet it is, each followed
by that of the azimuth that turns it, -1 without one; from the second to the first [m; body]; the second's diameter [m].
"""
JET_COLUMNS = 8
LEFT_PER_LENGTH, FADING = 0.75, 2.0 / 3.0
JET_SPREAD = 0.107


@kernel
def left_of_jet(pair: Floats, x: float, y: float, z: float) -> float:
    """Share of a jet along the unit vector (x, y, z) [body] that is left at the other thruster of a row of JET_COLUMNS.

    0 before the propeller, and without a diameter.
    """
    diameter = pair[DIAMETER]
    behind = pair[FROM_X] * x + pair[FROM_Y] * y + pair[FROM_Z] * z
    if behind <= 0.0 or diameter <= 0.0:
        return 0.0
    squared = pair[FROM_X] ** 2 + pair[FROM_Y] ** 2 + pair[FROM_Z] ** 2
    across = max(squared - behind * behind, 0.0)
    width = 0.5 * diameter + JET_SPREAD * behind
    along = LEFT_PER_LENGTH ** ((behind / diameter) ** FADING)
    left: float = along * math.exp(-across / (width * width))
    return left
