"""Thrust that is lost near the surface, where propellers draw air: T (1 - loss (1 - depth / reach)) above the reach.

Depth is that of the vehicle's origin, so that the reach holds how far the propellers lie below it.
Assumes: a loss that fades evenly with depth, the same for all thrusters, and none without water above.
Source: thrust diminution by ventilation; Faltinsen, Minsaas, Liapis and Skjordal, Proc. 13th Symposium on Naval
Hydrodynamics (1980).
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import SHARE, Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength


@kernel
def surface_loss(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take away what all thrusters lose at this depth."""
    loss, reach = unpack(parameters, 2)
    depth = max(-row[Z], 0.0)
    if depth >= reach:
        return
    lost = loss * (1.0 - depth / reach)
    for axis in range(4):
        total[axis] -= lost * moment.thrust[axis]


def _reaches(scene: Scene) -> list[float]:
    """Reaches of about a hull's length that the vehicle was clearly above and below; none where it kept away."""
    shallowest, deepest = -scene.upper[2], -scene.lower[2]
    return [
        share * scene.hull
        for share in (0.5, 1.0, 2.0)
        if shallowest < 0.7 * share * scene.hull and deepest > 1.3 * share * scene.hull
    ]


SURFACE_LOSS = Effect(
    summary="thrust that is lost near the surface",
    equation="T (1 - loss (1 - depth / reach)) above the reach",
    wrench=surface_loss,
    parameters=(
        Number(
            "loss",
            "1",
            "fraction of the thrust that is lost at the surface",
            sign="not negative",
            multiplies="N",
            gives="N",
            other_form=0.4,  # from the reach to the surface in another curve, most of which no vehicle visits
            search=Strength(large=0.3, least=0.0, most=3.0),
            between=SHARE,
            example=Example(0.3, "bollard pull at the surface and below"),
        ),
        Number(
            "reach",
            "m",
            "depth from which on nothing is lost",
            sign="not negative",
            gives="m",
            search=Grid(_reaches, logarithmic=True),
            example=Example(0.2, "bollard pull at the surface and below"),
        ),
    ),
    search=Search(channel="surge", group=DRAG, manoeuvre="depth_staircase"),
    needs=("thrusters",),
    check="Look for bubbles behind the propellers; weigh the thrust just below the surface and deep down.",
)
