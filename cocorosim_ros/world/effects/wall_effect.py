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
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Search, Strength


@kernel
def wall_effect(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the additional drag."""
    gain, range_ = unpack(parameters, 2)
    more = gain * math.exp(-moment.clearance / range_)
    speed = math.sqrt(relative[0] ** 2 + relative[1] ** 2 + relative[2] ** 2)
    for axis in range(3):
        total[axis] -= more * moment.drag * speed * relative[axis]
    total[3] -= more * moment.yaw_drag * abs(relative[3]) * relative[3]


WALL_EFFECT = Effect(
    summary="drag that grows near walls",
    equation="drag * (1 + gain * exp(-distance / range))",
    wrench=wall_effect,
    parameters=(
        Number(
            "gain",
            "1",
            "added fraction of the drag at contact",
            multiplies="kg m/s^2",
            gives="N",
            search=Strength(large=2.0, least=0.0),
            example=Example(0.8, "runs along a wall"),
            other_form=0.4,  # powers of the distance
        ),
        Number(
            "range",
            "m",
            "distance over which it falls to 1/e",
            neutral=0.2,
            sign="positive",
            needed=True,
            multiplies="1/m",
            gives="1",
            search=Grid(lambda scene: [0.05, 0.1, 0.2, 0.4], logarithmic=True),
            example=Example(0.15, "runs along a wall"),
            other_form=0.4,  # powers of the distance
        ),
    ),
    search=Search(channel="surge", group=DRAG, manoeuvre="along_wall"),
    check="Turns and speeds near the walls, the floor and the surface.",
)
