"""Water of changing density: what it lifts beyond that in which a robot is ballasted, (rho - rho_0) g V.

The force is that at the beginning of each tick and holds for it. Left out: that drag, thrust and the pump's lift grow
with the density too (2.5 % from fresh to sea water), and that a pressure sensor, calibrated in one density, errs.
"""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.state.state import X, Z
from cocorosim_ros.world.water.currents.gridded import interpolate


class Layers(NamedTuple):
    """The density of the water and how much of it each robot displaces."""

    density: Floats  # [kg/m^3], laid out as in water.currents.gridded, one number a place
    reference: Floats  # (robots,) in which it weighs what its platform says [kg/m^3]
    lift: Floats  # (robots,) gravity times volume [m^4/s^2]: newtons per kg/m^3


@kernel
def add_lift(state: Floats, time: float, layers: Layers, push: Floats) -> None:
    """Add to `push` (runs, robots, 4) what the water at `time` [s] lifts every robot of `state` [N; world]."""
    density = stack_array(1)
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            density[0] = 0.0
            interpolate(state[run, robot, X : Z + 1], time, layers.density, density)
            push[run, robot, 2] += layers.lift[robot] * (density[0] - layers.reference[robot])
