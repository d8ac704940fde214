"""Drag that grows near walls, floor and surface: all quadratic drag times gain exp(-h / range) more.

h is the distance of the robot's centre to the nearest of them. Obstacles in the water are not among them.
Assumes: one law for walls, floor and surface.
Source: that it grows as the gap closes is known of every hull near a boundary (Newman, Marine Hydrodynamics, 1977,
section 4.18); the exponential is the simplest form with a value at contact and a range.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def wall_effect(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the additional drag."""
    more = parameters[0] * math.exp(-moment.clearance / parameters[1])
    speed = math.sqrt(relative[0] ** 2 + relative[1] ** 2 + relative[2] ** 2)
    for axis in range(3):
        total[axis] -= more * moment.drag * speed * relative[axis]
    total[3] -= more * moment.yaw_drag * abs(relative[3]) * relative[3]


WALL_EFFECT = Effect(
    summary="drag grows near walls, floor and surface",
    wrench=wall_effect,
    parameters=(
        Parameter("gain", "1", "added fraction of the drag at contact"),
        Parameter("range", "m", "distance over which it falls to 1/e", 0.2, "positive", needed=True),
    ),
)
