"""A layer of density: below it the buoyancy differs by a force, above it does not.

The step is a cubic within 0.02 m above and below the layer, for water mixes and the hull has a height.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import WEIGHT
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength, spread

HALF_WIDTH = 0.02  # m
CROSSED = 0.1  # m above and below a layer that have to be visited


@kernel
def stratification(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force of the water below the layer."""
    depth, force = unpack(parameters, 2)
    share = (-row[Z] - depth + HALF_WIDTH) / (2.0 * HALF_WIDTH)
    share = min(max(share, 0.0), 1.0)
    total[2] += force * share * share * (3.0 - 2.0 * share)


def _depths(scene: Scene) -> list[float]:
    """Depths that were crossed: a layer that is never clearly above or below is as good as a part of the trim."""
    deepest, highest = scene.lower[2] + CROSSED, scene.upper[2] - CROSSED
    return [-value for value in spread(deepest, highest, 12)] if deepest < highest else []


STRATIFICATION = Effect(
    summary="density layer",
    equation="Z steps by force below depth",
    wrench=stratification,
    parameters=(
        Number(
            "depth",
            "m",
            "of the layer, positive down",
            needed=True,
            gives="m",
            other_form=0.015,  # where the middle of a layer is that has a width
            search=Grid(_depths),
            example=Example(1.0, "thermometer"),
        ),
        Number(
            "force",
            "N",
            "below against above, up positive",
            gives="N",
            other_form=0.1,  # layers that are thick, or come late
            search=Strength(large=2e-3),
            example=Example(1e-3, "thermometer"),
        ),
    ),
    search=Search(channel="heave", water=True, group=WEIGHT, manoeuvre="depth_staircase"),
    check="Warm water above cold, or fresh above salt: measure the temperature over depth.",
)
