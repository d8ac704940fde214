"""A buoyancy pump that is slow, or has backlash: a play, then time_constant B' = B_play - B.

The play is `backlash` wide, in fractions of the pump's largest command: half of it on either side is idle when the
command turns round.
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import LAGGED, MEMORY_SIZE, PLAY
from cocorosim_ros.world.terms.effect import Effect, Parameter
from cocorosim_ros.world.terms.response import delayed, relaxed


@kernel
def pump_lag(force: Floats, memory: Floats, fitting: Any, duration: float, parameters: Floats) -> None:
    """Turn the forces of the pumps into their means behind play and lag."""
    for actuator in range(force.shape[0]):
        if fitting.is_pump[actuator]:
            at = MEMORY_SIZE * actuator
            half = 0.5 * parameters[1] * fitting.limit[actuator, 0]
            target = min(max(memory[at + PLAY], force[actuator] - half), force[actuator] + half)
            begin = memory[at + LAGGED]
            force[actuator] = delayed(target, begin, duration, parameters[0])
            memory[at + PLAY] = target
            memory[at + LAGGED] = relaxed(target, begin, duration, parameters[0])


PUMP_LAG = Effect(
    summary="buoyancy pump slow, or with backlash",
    response=pump_lag,
    parameters=(
        Parameter("time_constant", "s", "after which 63 % of a step are there", 0.0, "not negative"),
        Parameter("backlash", "1", "width of the play, in fractions of the largest command", 0.0, "not negative"),
    ),
)
