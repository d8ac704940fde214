"""Thrust that follows its command late: time_constant F' = F_command - F, for thrusters only.

Source: Fossen (2021), section 9.2; a motor with a propeller is of first order around its operating point.
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import LAGGED, MEMORY_SIZE
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.response import delayed, relaxed


@kernel
def thruster_lag(force: Floats, memory: Floats, fitting: Any, duration: float, parameters: Floats) -> None:
    """Turn the forces of the thrusters into their means behind the lag."""
    for actuator in range(force.shape[0]):
        if not fitting.is_pump[actuator]:
            at = MEMORY_SIZE * actuator + LAGGED
            target, begin = force[actuator], memory[at]
            force[actuator] = delayed(target, begin, duration, parameters[0])
            memory[at] = relaxed(target, begin, duration, parameters[0])


THRUSTER_LAG = Effect(
    summary="thrust follows its command late",
    response=thruster_lag,
    parameters=(Parameter("time_constant", "s", "after which 63 % of a step are there", 0.0, "not negative"),),
)
