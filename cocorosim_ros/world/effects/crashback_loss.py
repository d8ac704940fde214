"""Thrust lost in crashback: against the motion a thruster gives F (1 - slope s), s being the speed against its push.

Water that comes against the jet of a propeller bends it back around the blades, into a ring vortex beside the disk:
of a propeller that stops a ship (crashback, second quadrant: ahead with the propeller astern), or one that goes ahead
while the ship still moves astern (fourth quadrant). Nothing is lost at rest or along the push; the water never turns
a thrust around, so that F (1 - slope s) is 0 at least. What is lost or gained in proportion to the speed on both sides
of rest is `advance_loss`, and a loss that does not ask for the speed `reverse_loss`; a recording tells them apart that
has thrust along the motion and against it.
Assumes: a straight line up to the speeds of the recordings; measured curves have their least thrust at some speed and
rise beyond. The speed is that of the vehicle's origin; a turned thruster loses along its axis and across it by itself.
Source: four-quadrant diagrams of the Wageningen B-series, van Lammeren, van Manen and Oosterveld, Trans. SNAME 77
(1969) 269; Fossen (2021), section 9.2; of thrusters of underwater vehicles: Healey et al., IEEE J. Oceanic Eng. 20
(1995) 354.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment, speed_along
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def crashback_loss(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take away what each thruster loses that pushes against the motion."""
    (slope,) = unpack(parameters, 1)
    for actuator in range(moment.actuator_wrench.shape[0]):
        if moment.is_pump[actuator]:
            continue
        wrench, force = moment.actuator_wrench[actuator], moment.force[actuator]
        along = speed_along(wrench, relative)
        against = -along if force > 0.0 else along
        if against <= 0.0:
            continue
        lost = min(slope * against, 1.0) * force
        for axis in range(4):
            total[axis] -= wrench[axis] * lost


CRASHBACK_LOSS = Effect(
    summary="thrust that is weaker against the motion",
    equation="T (1 - slope |u|) against the motion",
    wrench=crashback_loss,
    parameters=(
        Number(
            "slope",
            "s/m",
            "fraction of the thrust lost per speed against it",
            sign="not negative",
            multiplies="m/s",
            gives="1",
            search=Strength(large=3.0, least=0.0),
            example=Example(2.0, "stops from full speed with full reverse thrust"),
            other_form=0.1,  # curves bend on their way to the ring vortex
        ),
    ),
    search=Search(channel="surge", group=DRAG, manoeuvre="crash_stops"),
    needs=("thrusters",),
    check="Stop from full speed with reverse thrust, and weigh the same thrust at rest.",
)
