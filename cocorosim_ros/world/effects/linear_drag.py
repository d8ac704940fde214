"""Drag in proportion to speed: F = -d v along each body axis, N = -d r.

At the Reynolds numbers of small robots (below 1e4) friction is a part of the drag that no quadratic law has.
Source: Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2021), section 6.4.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def linear_drag(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the drag at the speed through the water."""
    surge, sway, heave, yaw = unpack(parameters, 4)
    total[0] -= surge * relative[0]
    total[1] -= sway * relative[1]
    total[2] -= heave * relative[2]
    total[3] -= yaw * relative[3]


LINEAR_DRAG = Effect(
    summary="linear drag",
    wrench=linear_drag,
    parameters=(
        Number(
            "surge",
            "N s/m",
            "force per speed forwards",
            multiplies="m/s",
            gives="N",
            part="X = -d_u u",
            other_form=0.25,  # powers of the speed from 0.75 to 1.6, at other speeds
            search=Strength(large=0.02, least=0.0),
            example=Example(0.01, "coast-down"),
        ),
        Number(
            "sway",
            "N s/m",
            "force per speed sideways",
            multiplies="m/s",
            gives="N",
            part="Y = -d_v v",
            other_form=0.25,  # powers of the speed from 0.75 to 1.6, at other speeds
            search=Strength(large=0.02, least=0.0),
            example=Example(0.012, "coast-down"),
        ),
        Number(
            "heave",
            "N s/m",
            "force per speed upwards",
            multiplies="m/s",
            gives="N",
            part="Z = -d_w w",
            other_form=0.25,  # powers of the speed from 0.75 to 1.6, at other speeds
            search=Strength(large=0.02, least=0.0),
            example=Example(0.012, "coast-down"),
        ),
        Number(
            "yaw",
            "N m s",
            "moment per yaw rate",
            multiplies="rad/s",
            gives="N m",
            part="N = -d_r r",
            other_form=0.25,  # powers of the speed from 0.75 to 1.6, at other speeds
            search=Strength(large=3e-5, least=0.0),
            example=Example(1.5e-5, "spin-down"),
        ),
    ),
    search=Search(channel="surge", group=DRAG, manoeuvre="coast_down"),
    check="Drag at low speed: fouling, fins, a tether in the water, a smoother or rougher hull than assumed.",
)
