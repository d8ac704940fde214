"""A spring towards a place: F = k (x0 - x), a cable or a thread that pulls."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import YAW, X, Y
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.moment import Moment


@kernel
def tether(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the pull, turned into the body."""
    pull_x = parameters[0] * (parameters[1] - row[X])
    pull_y = parameters[0] * (parameters[2] - row[Y])
    sine, cosine = sine_cosine(row[YAW])
    total[0] += pull_x * cosine + pull_y * sine
    total[1] += pull_y * cosine - pull_x * sine


TETHER = Effect(
    summary="pull towards a place",
    wrench=tether,
    parameters=(
        Parameter("stiffness", "N/m", "pull per distance"),
        Parameter("x", "m", "the place, in the world"),
        Parameter("y", "m", "the place, in the world"),
    ),
)
