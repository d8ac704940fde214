"""What an effect may know beside a robot's state: the time, the actuators, what is near."""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import MEMORY_SIZE, RATE, STATE_SIZE, X, Z

# Columns of a neighbour: place [m; world], force of its thrusters [N; world].
NEIGHBOUR_FORCE = 3
NEIGHBOUR_SIZE = 5


class Moment(NamedTuple):
    """One robot at one time."""

    time: float  # s, from the start of the run or recording
    thrust: Floats  # (4,) wrench of the thrusters, without any effect [N, N m; body]
    force: Floats  # (actuators,) [N]; of a rudder the angle [rad]
    actuator_wrench: Floats  # (actuators, 4) per newton [1, 1, 1, m; body]
    is_pump: Flags  # (actuators,)
    pump: float  # force of the pumps [N], up positive
    pump_rate: float  # its rate of change [N/s]
    drag: float  # quadratic, of the basic physics [kg/m]
    yaw_drag: float  # the same for turning [N m s^2]
    clearance: float  # to the nearest of walls, floor and surface [m]
    neighbours: Floats  # (robots, NEIGHBOUR_SIZE), the robot itself among them; empty if nobody looks
    own: int  # the row of the robot itself, -1 if it is not among them
    advance_loss: float  # of the thrusters, fraction of the thrust lost per speed [s/m]
    jets: Floats  # (pairs, JET_COLUMNS) thrusters that may stand in each other's jets, see terms.jet


@kernel
def clearance(row: Floats, lower: Floats, upper: Floats) -> float:
    """Distance [m] to the nearest of walls, floor and surface; `lower`, `upper` (3,): its corners."""
    nearest = math.inf
    for axis in range(3):
        nearest = min(nearest, row[X + axis] - lower[axis], upper[axis] - row[X + axis])
    return max(nearest, 0.0)


@kernel
def add_thrust(force: Floats, actuator_wrench: Floats, is_pump: Flags, total: Floats) -> None:
    """Add the wrench of all thrusters to `total` (4,)."""
    for actuator in range(actuator_wrench.shape[0]):
        if not is_pump[actuator]:
            for axis in range(4):
                total[axis] += actuator_wrench[actuator, axis] * force[actuator]


@kernel
def speed_along(wrench: Floats, relative: Floats) -> float:
    """Speed through the water [m/s] of the vehicle's origin in the direction of the push of an actuator.

    wrench: of the actuator, per newton, X, Y, Z first; relative: velocity through the water, u, v, w first [m/s; body].
    """
    along = 0.0
    for axis in range(3):
        along += wrench[axis] * relative[axis]
    return along


@kernel
def pump_force(row: Floats, is_pump: Flags) -> tuple[float, float]:
    """Force [N] of all pumps of a robot, and the rate [N/s] at which it changes."""
    actuators = is_pump.shape[0]
    memory = STATE_SIZE + 2 * actuators
    remembered = row.shape[0] >= memory + MEMORY_SIZE * actuators
    force, rate = 0.0, 0.0
    for actuator in range(actuators):
        if is_pump[actuator]:
            force += row[STATE_SIZE + actuator]
            rate += row[memory + MEMORY_SIZE * actuator + RATE] if remembered else 0.0
    return force, rate


@kernel
def neighbour_distance(row: Floats, neighbours: Floats, own: int) -> float:
    """Distance [m] to the nearest neighbour, +inf if there is none."""
    nearest = math.inf
    for other in range(neighbours.shape[0]):
        if other != own:
            squared = 0.0
            for axis in range(Z + 1):
                squared += (neighbours[other, axis] - row[X + axis]) ** 2
            nearest = min(nearest, squared)
    return math.sqrt(nearest)
