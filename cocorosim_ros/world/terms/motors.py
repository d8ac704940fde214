"""What the motors of a robot do together: the part of their full thrust that they give, each by its own amount."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.terms.curve import is_thruster


class Motors(NamedTuple):
    """The actuators of one robot, as far as it takes them to find its thrusters and their full thrust."""

    is_pump: Flags  # (actuators,)
    curve: Floats  # (actuators, columns) see terms.curve
    limit: Floats  # (actuators, 2) force at command +1 and -1, both positive [N]


@kernel
def motor_share(row: Floats, motors: Motors) -> float:
    """Sum of the amounts of all thrusts over their sum at full command [1]; 0 without thrusters.

    row: the state with the forces of the actuators behind it (state.state).
    """
    given, full = 0.0, 0.0
    for actuator in range(motors.limit.shape[0]):
        if is_thruster(motors.is_pump, motors.curve, actuator):
            given += abs(row[STATE_SIZE + actuator])
            full += motors.limit[actuator, 0]
    return given / full if full > 0.0 else 0.0
