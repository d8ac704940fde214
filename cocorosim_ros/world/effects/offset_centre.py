"""A centre of mass off the origin in which thrusters, drag and poses are told: motion along and about axes is coupled.

With the centre of mass x_g ahead of the origin and y_g left of it:
m (u_dot - v r - x_g r^2 - y_g r_dot) = X, m (v_dot + u r + x_g r_dot - y_g r^2) = Y,
I_z r_dot + m x_g (v_dot + u r) - m y_g (u_dot - v r) = N, with I_z = I + m (x_g^2 + y_g^2) about the origin and I, the
platform's yaw inertia, about the centre of mass: so a body can have each offset. Added mass stays where the origin is;
its terms are those of effects.added_mass. One that is negative sideways leaves less against a turn, the more the
farther x_g is: where I + A_r + m x_g^2 A_v / (m + A_v) is not above zero, vehicle_model.plausible_body refuses both.
A pose of another point (sensors.errors.pose_lever) moves poses in turns alike and leaves heading and turn rate as they
are. A vehicle whose centre is ahead resists turns under way by N = -m x_g u r, and answers a force to the side with a
turn: heading, compass and gyro tell the two apart.
Assumes: weight and buoyancy do not turn the hull, which stays level.
Source: Fossen (2021), sections 3.3 and 6.5.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def offset_centre(parameters: Floats, place: Floats) -> None:
    """Add the place of the centre of mass (2,), ahead of the origin and left of it [m; body]."""
    ahead, left = unpack(parameters, 2)
    place[0] += ahead
    place[1] += left


END = 6.5
"""Largest offset that a diagnosis looks for, in `large` amounts of 1/13 of the hull's length: an end of the hull."""

OFFSET_CENTRE = Effect(
    summary="centre of mass off the origin",
    centre=offset_centre,
    parameters=(
        Number(
            "ahead",
            "m",
            "the centre of mass before the origin",
            multiplies="N",
            gives="N m",
            part="N = -m ahead (v' + u r) with X = m ahead r^2 and Y = -m ahead r'",
            search=Strength(large=0.01, least=-END, most=END),
            example=Example(0.01, "balanced on an edge"),
        ),
        Number(
            "left",
            "m",
            "the centre of mass to the left of the origin",
            multiplies="N",
            gives="N m",
            part="N = m left (u' - v r) with X = m left r' and Y = m left r^2",
            search=Strength(large=0.01, least=-END, most=END),
            example=Example(0.002, "balanced on an edge"),
        ),
    ),
    search=Search(channel="yaw", manoeuvre="zig_zag"),
    check="Balance the vehicle on an edge, with any water that it carries: the file's origin should lie on it.",
)
