"""A buoyancy pump that is slow, or has backlash: a play, then time_constant B' = B_play - B.

The play is `backlash` wide, in fractions of the pump's largest command: half of it on either side is idle when the
command turns round.
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import LAGGED, MEMORY_SIZE, PLAY
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.response import delayed, relaxed
from cocorosim_ros.world.terms.search import Search, Strength

PUMP_TICK = 0.04  # s: below, a pump answers at once, and what is late is a clock
NO_PLAY = 0.002  # of a full command: below, a linkage has no play


@kernel
def pump_lag(force: Floats, memory: Floats, fitting: Any, duration: float, parameters: Floats) -> None:
    """Turn the forces of the pumps into their means behind play and lag."""
    time_constant, backlash = unpack(parameters, 2)
    for actuator in range(force.shape[0]):
        if fitting.is_pump[actuator]:
            at = MEMORY_SIZE * actuator
            half = 0.5 * backlash * fitting.limit[actuator, 0]
            target = min(max(memory[at + PLAY], force[actuator] - half), force[actuator] + half)
            begin = memory[at + LAGGED]
            force[actuator] = delayed(target, begin, duration, time_constant)
            memory[at + PLAY] = target
            memory[at + LAGGED] = relaxed(target, begin, duration, time_constant)


PUMP_LAG = Effect(
    summary="slow buoyancy pump",
    response=pump_lag,
    parameters=(
        Number(
            "time_constant",
            "s",
            "after which 63 % of a step are there",
            sign="not negative",
            multiplies="N/s",
            gives="N",
            part="tau dZ/dt = Z_command - Z",
            search=Strength(large=1.0, step=0.1, least=0.0, negligible=(-PUMP_TICK, PUMP_TICK)),
            example=Example(1.5, "step response"),
        ),
        Number(
            "backlash",
            "1",
            "width of the play, in fractions of the largest command",
            sign="not negative",
            multiplies="N",
            gives="N",
            part="Z_command with a play",
            search=Strength(large=0.06, step=0.1, least=0.0, negligible=(-NO_PLAY, NO_PLAY)),
            between=(0.0, 2.0),  # from the largest command to the least
            example=Example(0.05, "triangle"),
        ),
    ),
    search=Search(channel="heave", group="late pump", of_pump=True, manoeuvre="pump_triangle"),
    check="Time from command to volume of the pump, and play when it changes direction.",
)
