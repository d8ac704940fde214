"""Lift of a hull that drifts, climbs or turns ahead: Y = -a |u| v - b |u| r, N = -c |u| v - d |u| r, Z = -e |u| w.

A ship's hull is a wing of little span: forces across grow with the speed ahead, where drag by its own speed across
would be small. Assumes: small angles of drift. The moment that turns a drifting hull further, Munk's, is of added mass;
c is what is left beside that. Of a slender hull a, c and e are looked for; what turns do, b and d, is that of fins and
drag too, and only fitted where a platform gives it with a range.
Source: the first-order terms of Blanke's model of a ship, Fossen (2021), section 7.1; Y_uv, Y_ur, N_uv, N_ur there,
and Z_uw of a torpedo, section 8.4.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Given, Search, Strength


@kernel
def hull_lift(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the lift at the speed ahead through the water."""
    sway_by_drift, sway_by_turn, yaw_by_drift, yaw_by_turn, heave_by_climb = unpack(parameters, 5)
    ahead = abs(relative[0])
    total[1] -= ahead * (sway_by_drift * relative[1] + sway_by_turn * relative[3])
    total[2] -= ahead * heave_by_climb * relative[2]
    total[3] -= ahead * (yaw_by_drift * relative[1] + yaw_by_turn * relative[3])


HULL_LIFT = Effect(
    summary="lift of the hull",
    wrench=hull_lift,
    parameters=(
        Number(
            "sway_by_drift", "kg/m", "a, force across by the speed across",
            multiplies="m^2/s^2", gives="N", part="Y = -a |u| v",
            search=Strength(large=5.0, least=-0.2), example=Example(2.0, "towing"),
            other_form=0.06,  # lift that falls off at large angles of attack
        ),
        Number(
            "sway_by_turn", "kg", "b, force across by the yaw rate",
            multiplies="m/s^2", gives="N", part="Y = -b |u| r", search=Given(lambda scene: 0.0),
            example=Example(0.0, "towing in circles"),
        ),
        Number(
            "yaw_by_drift", "kg", "c, moment by the speed across",
            multiplies="m^2/s^2", gives="N m", part="N = -c |u| v", search=Strength(large=0.04),
            example=Example(0.0, "towing"),
            other_form=0.06,  # as for a
        ),
        Number(
            "yaw_by_turn", "kg m", "d, moment by the yaw rate",
            multiplies="m/s^2", gives="N m", part="N = -d |u| r", search=Given(lambda scene: 0.0),
            example=Example(0.01, "towing in circles"),
        ),
        Number(
            "heave_by_climb", "kg/m", "e, force upwards by the speed upwards",
            multiplies="m^2/s^2", gives="N", part="Z = -e |u| w",
            search=Strength(large=5.0, least=-0.2), example=Example(2.0, "towing"),
            other_form=0.06,  # lift that falls off at large angles of attack
        ),
    ),
    needs=("slender_hull",),
    search=Search(channel="sway", group=DRAG, manoeuvre="zig_zag"),
    check="Tow the vehicle at a few angles of drift and weigh the force across; compare with a wing of that outline.",
)  # fmt: skip
