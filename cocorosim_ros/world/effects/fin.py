"""A fin of a vehicle that neither rolls nor pitches: F = 1/2 rho S c |V_x| (V_x d - V_n) along its normal n.

V = (u - y r, v + x r, w) is the velocity of the fin through the water, V_n = n V; on the vehicle acts X = n_x F,
Y = n_y F, Z = n_z F and N = (x n_y - y n_x) F. Its moments in roll and pitch are held by what keeps the vehicle level.
The angle d, of the command and the trim, is that of the fin to the level: what recorded rolls and pitches add is in d.
Assumes: small angles of attack, no stall, no drag of the lift, no wash of a propeller; see terms.control_surface.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.control_surface import fin_lift
from cocorosim_ros.world.terms.effect import Effect, Number
from cocorosim_ros.world.terms.moment import Moment


@kernel
def fin(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the lift of the fin."""
    actuator, x, y, forward, left, up, area, slope, density, gain, trim = unpack(parameters, 11)
    if area <= 0.0:
        return
    ahead = relative[0] - y * relative[3]
    across = forward * ahead + left * (relative[1] + x * relative[3]) + up * relative[2]
    lift = fin_lift(0.5 * density * area * slope * gain, ahead, across, moment.force[int(actuator)] + trim)
    total[0] += forward * lift
    total[1] += left * lift
    total[2] += up * lift
    total[3] += (x * left - y * forward) * lift


FIN = Effect(
    summary="fin",
    equation="F = 1/2 rho S c |V_x| (V_x d - V_n)",
    wrench=fin,
    parameters=(
        Number("actuator", "1", "place of its angle among the actuators", gives="1"),
        Number("x", "m", "place of its centre of pressure before the centre", gives="m"),
        Number("y", "m", "place of its centre of pressure to the left of the centre", gives="m"),
        Number("forward", "1", "part of its normal along the hull", gives="1"),
        Number("left", "1", "part of its normal to the left", gives="1"),
        Number("up", "1", "part of its normal upwards", gives="1"),
        Number("area", "m^2", "area of the fin", gives="m^2"),
        Number("slope", "1/rad", "c, lift coefficient over the angle of attack", gives="1/rad"),
        Number("density", "kg/m^3", "of the water", gives="kg/m^3"),
        Number("gain", "1", "force over what the law says", neutral=1.0, gives="1"),
        Number("trim", "rad", "angle at which it stands at command zero", gives="rad"),
    ),
)
