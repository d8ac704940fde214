"""Pressure: the weight of air and water above, P = 101325 Pa - rho g z.

Source: hydrostatics; the constants are the contract's.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE
from cocorosim_ros.world.state.state import Z


@kernel
def absolute_pressure(row: Floats, density: float, gravity: float) -> float:
    """Absolute pressure [Pa] at the robot whose state is `row`; `density` [kg/m^3], `gravity` [m/s^2]."""
    pressure: float = SURFACE_PRESSURE - density * gravity * row[Z]
    return pressure
