"""A rudder, perhaps behind a propeller: MMG's normal force F_N = 1/2 rho A U_R^2 f sin(alpha_R).

Angle d, positive to the left, of the command and the trim; flow at the rudder u_R along the hull and v_R to its left,
U_R = sqrt(u_R^2 + v_R^2): f = 6.13 L / (L + 2.25) of the aspect ratio L;
U_R sin(alpha_R) = u_R sin(d) + v_R cos(d); v_R = gamma (v + l_R r).
Without a propeller u_R = u_P = (1 - wake) u. A propeller of diameter D and thrust T accelerates the water from u_P to
u_j = u_P + kappa (sqrt(u_P^2 + 8 T / (pi rho D^2)) - |u_P|); where the share eta of the rudder stands in that jet,
u_R^2 = eta u_j^2 + (1 - eta) u_P^2, flows from behind counted negative. On the vehicle acts
X = -d_s F_N sin(d), Y = -(1 + a_H) F_N cos(d), N = -(x + a_H x_H) F_N cos(d) + y d_s F_N sin(d).
gamma: flow straightening by the hull; l_R: arm at which it meets the turning flow; d_s = 1 - t_R; a_H and x_H: force on
the hull beside the rudder's, and where it acts. Without hull gamma = d_s = 1, l_R = x, a_H = wake = 0; the whole jet:
kappa = eta = 1. The thrust is that at speed, where advance_loss says how it falls.
Assumes: no stall, no time for the flow to settle.
Source: Yasukawa and Yoshimura, J. Mar. Sci. Technol. 20 (2015) 37, equations (19) to (26); f: Fujii's formula there.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import SHARE, Effect, Number
from cocorosim_ros.world.terms.moment import Moment


@kernel
def _along_the_rudder(ahead: float, jet: float, acceleration: float, coverage: float) -> float:
    """u_R [m/s] of a flow `ahead` [m/s] of which a part passes a propeller; jet: 8 T / (pi rho D^2) [m^2/s^2]."""
    if jet <= 0.0:
        return ahead
    behind = ahead + acceleration * (math.sqrt(ahead * ahead + jet) - abs(ahead))
    square = coverage * abs(behind) * behind + (1.0 - coverage) * abs(ahead) * ahead
    return math.copysign(math.sqrt(abs(square)), square)


@kernel
def rudder(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force of the rudder, and that which it causes on the hull."""
    (
        actuator, propeller, x, y, area, slope, density, diameter,
        gain, wake, acceleration, coverage, straightening, inflow_arm, drag_share, hull_gain, hull_position,
        trim,
    ) = unpack(parameters, 18)  # fmt: skip
    if area <= 0.0:
        return
    sine, cosine = sine_cosine(moment.force[int(actuator)] + trim)
    jet = 0.0
    if propeller >= 0.0 and diameter > 0.0:
        thrust = moment.force[int(propeller)]
        thrust -= moment.advance_loss * abs(thrust) * relative[0]
        jet = 8.0 * thrust / (math.pi * density * diameter * diameter)
    along = _along_the_rudder((1.0 - wake) * relative[0], jet, acceleration, coverage)
    across = straightening * (relative[1] + inflow_arm * relative[3])
    speed = math.sqrt(along * along + across * across)
    normal = 0.5 * density * area * slope * gain * speed * (along * sine + across * cosine)
    total[0] -= drag_share * normal * sine
    total[1] -= (1.0 + hull_gain) * normal * cosine
    total[3] -= (x + hull_gain * hull_position) * normal * cosine - y * drag_share * normal * sine


RUDDER = Effect(
    summary="rudder",
    equation="F_N = 1/2 rho A U_R^2 f sin(alpha_R)",
    wrench=rudder,
    parameters=(
        Number("actuator", "1", "place of its angle among the actuators", gives="1"),
        Number("propeller", "1", "place of the thruster before it, -1 without one", neutral=-1.0, gives="1"),
        Number("x", "m", "place of the stock before the centre", gives="m"),
        Number("y", "m", "place of the stock to the left of the centre", gives="m"),
        Number("area", "m^2", "area that moves", gives="m^2"),
        Number("slope", "1", "f, lift over sine of the angle of attack", gives="1"),
        Number("density", "kg/m^3", "of the water", gives="kg/m^3"),
        Number("diameter", "m", "of the propeller before it", gives="m"),
        Number("gain", "1", "force over what the law says", neutral=1.0, gives="1"),
        Number("wake", "1", "speed that the hull takes off the water at the rudder", gives="1"),
        Number("acceleration", "1", "kappa, how much of the jet's speed is there", neutral=1.0, gives="1"),
        Number(
            "coverage", "1", "eta, share of the rudder that stands in the jet", neutral=1.0, gives="1", between=SHARE
        ),
        Number("straightening", "1", "gamma, what the hull leaves of the flow across", neutral=1.0, gives="1"),
        Number("inflow_arm", "m", "l_R, at which the rudder meets the turning flow", gives="m"),
        Number(
            "drag_share",
            "1",
            "d_s, what of the drag of the rudder the vehicle feels",
            neutral=1.0,
            gives="1",
            between=SHARE,
        ),
        Number("hull_gain", "1", "a_H, force on the hull over that on the rudder", gives="1"),
        Number("hull_position", "m", "x_H, where that force acts before the centre", gives="m"),
        Number("trim", "rad", "angle at which it stands at command zero", gives="rad"),
    ),
)
