"""A steady current that this robot feels: the velocity (x, y) of the water.

The velocity itself is that of currents.uniform.
"""

from __future__ import annotations

from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import MOVING_WATER
from cocorosim_ros.world.terms.search import Search, Strength
from cocorosim_ros.world.water.currents.uniform import uniform

STEADY_CURRENT = Effect(
    summary="steady current",
    equation="u, v through the water: V - V_c",
    water=uniform,
    parameters=(
        Number(
            "x",
            "m/s",
            "velocity along x of the world",
            gives="m/s",
            part="V_cx = x",
            search=Strength(large=0.005),
            example=Example(0.005, "drift"),
        ),
        Number(
            "y",
            "m/s",
            "velocity along y of the world",
            gives="m/s",
            part="V_cy = y",
            search=Strength(large=0.005),
            example=Example(-0.002, "drift"),
        ),
    ),
    search=Search(channel="surge", water=True, group=MOVING_WATER, manoeuvre="four_headings"),
    check="Filter pumps, inflows, convection: let a float drift, and see whether all robots drift alike.",
)
