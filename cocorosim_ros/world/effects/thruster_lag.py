"""Thrust that follows its command late: time_constant F' = F_command - F, for thrusters only.

Source: Fossen (2021), section 9.2; a motor with a propeller is of first order around its operating point.
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import LAGGED, MEMORY_SIZE
from cocorosim_ros.world.terms.curve import is_thruster
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import LATE
from cocorosim_ros.world.terms.response import delayed, relaxed
from cocorosim_ros.world.terms.search import DELAYS, Search, Strength

AT_ONCE = 0.02  # s: below, thrust is there at once, and what is late is a clock


@kernel
def thruster_lag(force: Floats, memory: Floats, fitting: Any, duration: float, parameters: Floats) -> None:
    """Turn the forces of the thrusters into their means behind the lag."""
    (time_constant,) = unpack(parameters, 1)
    for actuator in range(force.shape[0]):
        if is_thruster(fitting.is_pump, fitting.curve, actuator):
            at = MEMORY_SIZE * actuator + LAGGED
            target, begin = force[actuator], memory[at]
            force[actuator] = delayed(target, begin, duration, time_constant)
            memory[at] = relaxed(target, begin, duration, time_constant)


THRUSTER_LAG = Effect(
    summary="thrust that lags behind its command",
    equation="tau dT/dt = T_command - T",
    response=thruster_lag,
    parameters=(
        Number(
            "time_constant",
            "s",
            "after which 63 % of a step are there",
            sign="not negative",
            multiplies="N/s",
            gives="N",
            other_form=0.02,  # motors whose current lags too
            search=Strength(large=0.3, least=0.0, negligible=(-AT_ONCE, AT_ONCE), searched=DELAYS),
            example=Example(0.3, "step response"),
        ),
    ),
    search=Search(channel="surge", group=LATE, manoeuvre="steps"),
    check="Time from command to full thrust: motor controller, filters of the command, propeller inertia.",
)
