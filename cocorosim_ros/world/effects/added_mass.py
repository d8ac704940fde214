"""Water that is accelerated with the hull: added mass, with its Coriolis and Munk terms.

Added mass A sideways, A_w upwards and none forwards (what all have in common cannot be told from mass), A_r in yaw:
m u_dot = X + m v r + A v_r r, (m + A) v_dot = Y - m u r - A r (u - u_r), (I + A_r) r_dot = N - A u_r v_r,
with the velocity v_r through the water; the second, written with what is added to the force, is
v_dot = (Y + A u_r r) / (m + A) - u r; and (m + A_w) w_dot = Z.
Assumes: the current is the same wherever the robot goes and changes slowly.
Source: Fossen (2021), sections 6.3 and 10.3; the moment A u_r v_r is Munk's.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def added_mass_wrench(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the Coriolis terms of the added mass."""
    sway_minus_surge, _, _ = unpack(parameters, 3)
    total[0] += sway_minus_surge * relative[1] * relative[3]
    total[1] += sway_minus_surge * relative[0] * relative[3]
    total[3] -= sway_minus_surge * relative[0] * relative[1]


@kernel
def added_inertia(parameters: Floats, inertia: Floats) -> None:
    """Add the inertia of the water to (4,) that of surge, sway, heave [kg] and yaw [kg m^2]."""
    sway_minus_surge, yaw, heave_minus_surge = unpack(parameters, 3)
    inertia[1] += sway_minus_surge
    inertia[2] += heave_minus_surge
    inertia[3] += yaw


LEAST = -5.0
"""Least difference of added mass that a diagnosis looks for, in `large` amounts of a tenth of the mass: half of it.

The mass of a platform holds the added mass forwards. A difference of more than that would make the robot lighter than
it is in air; of a sphere, which is blunter than most hulls, it is a third of the mass (Fossen 2021, section 6.3).
"""

ADDED_MASS = Effect(
    summary="added mass",
    wrench=added_mass_wrench,
    inertia=added_inertia,
    parameters=(
        Number(
            "sway_minus_surge",
            "kg",
            "added mass sideways less that forwards",
            multiplies="m^2/s^2",
            gives="N m",
            part="N = -(A_v - A_u) u v and inertia against sway",
            search=Strength(large=0.044, least=LEAST),
            example=Example(0.04, "zig-zag"),
        ),
        Number(
            "yaw",
            "kg m^2",
            "added moment of inertia",
            multiplies="rad/s^2",
            gives="N m",
            part="inertia against yaw",
            search=Strength(large=6e-5),
            example=Example(6e-5, "zig-zag"),
        ),
        Number(
            "heave_minus_surge",
            "kg",
            "added mass upwards less that forwards",
            multiplies="m/s^2",
            gives="N",
            part="inertia against heave",
            search=Strength(large=0.044, least=LEAST),
            example=Example(0.04, "zig-zag"),
        ),
    ),
    search=Search(channel="yaw", manoeuvre="zig_zag"),
    check="Compare with the added mass of an ellipsoid of the hull's size; a model of any hull needs it.",
)
