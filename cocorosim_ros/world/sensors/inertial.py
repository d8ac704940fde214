"""IMU: yaw rate and specific force, after REP 145: at rest it reads +g upwards.

The specific force is the acceleration of the hull in body axes less gravity, at the very moment of the
measurement, under the forces that the actuators deliver then.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW_RATE


@kernel
def specific_force(row: Floats, rate: Floats, gravity: float, reading: Floats) -> None:
    """Write the specific force (3,) [m/s^2; body] of a robot with state `row` and state rate `rate`."""
    reading[0] = rate[SURGE] - row[SWAY] * row[YAW_RATE]
    reading[1] = rate[SWAY] + row[SURGE] * row[YAW_RATE]
    reading[2] = rate[HEAVE] + gravity


@kernel
def angular_rate(row: Floats, reading: Floats) -> None:
    """Write the angular rate (3,) [rad/s; body]: the vehicle neither pitches nor rolls."""
    reading[0] = 0.0
    reading[1] = 0.0
    reading[2] = row[YAW_RATE]
