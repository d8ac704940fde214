"""Buoyancy that is lost with depth, because the hull shrinks: Z = -gradient depth; none at the surface.

Assumes: it shrinks in proportion to the pressure, as a stiff hull does. Gas gives way less the more it is pressed; what
swells is no gas, and goes in proportion to depth.
Source: Graver, Underwater Gliders (2005), section 4.1.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import WEIGHT
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Search, Strength

ATMOSPHERE = 10.33  # m of water that weigh as much as the air above


@kernel
def hull_compressibility(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the buoyancy that is lost."""
    gradient, gas = unpack(parameters, 2)
    depth = max(-row[Z], 0.0)
    yielding = gas if gradient > 0.0 else 0.0
    total[2] -= gradient * depth / (1.0 + yielding * depth / ATMOSPHERE)


HULL_COMPRESSIBILITY = Effect(
    summary="hull that shrinks with depth",
    opposite="hull that swells with depth",
    equation="Z = -gradient * depth",
    wrench=hull_compressibility,
    parameters=(
        Number(
            "gradient",
            "N/m",
            "buoyancy lost per metre, at the surface, positive for a hull that shrinks",
            multiplies="m",
            gives="N",
            search=Strength(large=2e-3),
            example=Example(1e-3, "staircase of depths"),
            other_form=0.08,  # the mean over the depths, of which the one at the surface is the steepest
        ),
        Number(
            "gas",
            "1",
            "elastic_hull or 0: in proportion to depth; gas or 1: a volume of gas that shrinks, by Boyle's law",
            gives="1",
            search=Grid(lambda scene: [0.0, 1.0], fixed=True),
            example=Example(0.0, "staircase of depths"),
        ),
    ),
    search=Search(channel="heave", group=WEIGHT, manoeuvre="depth_staircase"),
    check="A hull that gives way, trapped air, or denser water below: weigh the robot in the water at two depths.",
)
