"""A weight that differs from the buoyancy, beyond what the platform says."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import WEIGHT
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def buoyancy_trim(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force."""
    (force,) = unpack(parameters, 1)
    total[2] += force


BUOYANCY_TRIM = Effect(
    summary="net weight or buoyancy",
    equation="Z = const",
    wrench=buoyancy_trim,
    parameters=(
        Number(
            "force",
            "N",
            "up positive",
            gives="N",
            other_form=0.06,  # a trim that differs from place to place
            search=Strength(large=1e-3),
            example=Example(-5e-4, "drift"),
        ),
    ),
    search=Search(channel="heave", group=WEIGHT, manoeuvre="depth_staircase"),
    check="Weigh the robot in the water: add or take away ballast.",
)
