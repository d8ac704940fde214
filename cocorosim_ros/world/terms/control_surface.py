"""The lift of a fin that turns as a whole, the same for motion in four and in six degrees of freedom."""

from __future__ import annotations

from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def fin_lift(coefficient: float, ahead: float, across: float, angle: float) -> float:
    """The force [N] along the normal of a fin at an angle [rad], in water that it meets ahead and across [m/s].

    coefficient: 1/2 rho S c of density, area and lift slope [kg/m]. c |V_x| (V_x angle - V_n), with V_x ahead along the
    hull and V_n along the fin's normal. Assumes: small angles of attack, no stall, no drag of the lift, no wash of a
    propeller. Source: Prestero, Verification of a Six-Degree of Freedom Simulation Model for the REMUS AUV (2001),
    section 4.6.
    """
    return coefficient * abs(ahead) * (ahead * angle - across)
