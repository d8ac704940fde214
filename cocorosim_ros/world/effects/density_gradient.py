"""Buoyancy that is gained with depth, because the water grows denser: Z = gradient depth; none at the surface.

Assumes: a density that grows evenly with depth, and a hull that keeps its volume, so that the gradient is that of the
density times g and volume. A hull that swells with depth would have the same force. They differ in that the water is
the same for all robots, and a hull is each robot's own; the recording of one robot cannot tell them, and names both.
Source: Turner, Buoyancy Effects in Fluids (1973), chapter 1.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import WEIGHT
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def density_gradient(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the buoyancy that is gained."""
    (gradient,) = unpack(parameters, 1)
    total[2] += gradient * max(-row[Z], 0.0)


DENSITY_GRADIENT = Effect(
    summary="water that grows denser with depth",
    equation="Z = gradient * depth",
    wrench=density_gradient,
    parameters=(
        Number(
            "gradient",
            "N/m",
            "buoyancy gained per metre of depth; water that is lighter below does not stay there",
            sign="not negative",
            multiplies="m",
            gives="N",
            search=Strength(large=2e-3, least=0.0),
            example=Example(1e-3, "density over depth"),
            other_form=0.08,  # the mean over the depths; as for hull_compressibility
        ),
    ),
    search=Search(channel="heave", water=True, group=WEIGHT, manoeuvre="depth_staircase"),
    check="Measure temperature and salt over depth; weigh the robot in the water at two depths.",
)
