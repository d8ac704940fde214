"""Buoyancy that is lost where the hull is out of the water: Z = -share weight (1/2 + z / height) at the surface.

A hull whose middle lies at z loses nothing below -height / 2, and all of its share above height / 2.
Assumes: a wall-sided hull whose middle is the origin, a flat surface at z = 0. A hull that floats bobs at the rate
sqrt(share weight / (height mass)), which steps of time have to follow.
Source: hydrostatic force on a wall-sided body; Fossen (2021), section 4.2.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import SHARE, Effect, Example, Number
from cocorosim_ros.world.terms.groups import WEIGHT
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Given, Grid, Scene, Search, Strength


@kernel
def hull_emergence(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take away the buoyancy of what is out of the water."""
    share, height, weight = unpack(parameters, 3)
    if row[Z] <= -0.5 * height or height <= 0.0:
        return
    total[2] -= share * weight * min(0.5 + row[Z] / height, 1.0)


def _heights(scene: Scene) -> list[float]:
    """The hull's own height, where it came up to the surface and went down from there."""
    half = 0.5 * scene.height
    return [scene.height] if scene.upper[2] > -half > scene.lower[2] else []


HULL_EMERGENCE = Effect(
    summary="hull that leaves the water",
    equation="Z = -share * weight * (1/2 + z / height) at the surface",
    wrench=hull_emergence,
    parameters=(
        Number(
            "share",
            "1",
            "of the weight, by which buoyancy is less when all of the hull is out",
            sign="not negative",
            multiplies="N",
            gives="N",
            search=Strength(large=0.5, least=0.0),
            between=SHARE,
            example=Example(0.8, "drawing"),
        ),
        Number(
            "height",
            "m",
            "of the hull",
            sign="not negative",
            gives="m",
            search=Grid(_heights, fixed=True),
            example=Example(0.15, "drawing"),
        ),
        Number(
            "weight",
            "N",
            "of the vehicle in air",
            sign="not negative",
            gives="N",
            search=Given(lambda scene: scene.weight),
            example=Example(4.3, "scales"),
        ),
    ),
    search=Search(channel="heave", group=WEIGHT, manoeuvre="surface_touch"),
    needs=("tall_hull",),
    check="Whether the hull, a mast or a handle stands out of the water at the surface, and how much of it.",
)
