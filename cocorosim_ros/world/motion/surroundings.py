"""What robots are near one another, for the effects that want to know."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel, stack_array
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.state.state import STATE_SIZE, YAW, X, Z
from cocorosim_ros.world.terms.moment import NEIGHBOUR_FORCE, NEIGHBOUR_SIZE, add_thrust
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, LAW_BITS, Vehicles

LOOKING = LAW_BITS | sum(EFFECT_BIT[name] for name, effect in EFFECTS.items() if effect.neighbours)


@kernel
def _somebody_looks(vehicles: Vehicles) -> bool:
    looking = 0
    for run in range(vehicles.active.shape[0]):
        for robot in range(vehicles.active.shape[1]):
            looking |= vehicles.active[run, robot] & LOOKING
    return looking != 0


@kernel
def describe_neighbour(row: Floats, actuator_wrench: Floats, is_pump: Flags, neighbour: Floats) -> None:
    """Write (NEIGHBOUR_SIZE,) the place [m] and the thrusters' horizontal force [N] of a robot, both in the world."""
    thrust = stack_array(4)
    add_thrust(row[STATE_SIZE:], actuator_wrench, is_pump, thrust)
    sine, cosine = sine_cosine(row[YAW])
    for axis in range(Z + 1):
        neighbour[axis] = row[X + axis]
    neighbour[NEIGHBOUR_FORCE] = thrust[0] * cosine - thrust[1] * sine
    neighbour[NEIGHBOUR_FORCE + 1] = thrust[0] * sine + thrust[1] * cosine


@allocating_kernel
def look_around(state: Floats, vehicles: Vehicles) -> Floats:
    """(runs, robots, NEIGHBOUR_SIZE) all robots as their neighbours feel them; (1, 0, ...) if no effect asks."""
    if not _somebody_looks(vehicles):
        return np.empty((1, 0, NEIGHBOUR_SIZE))
    runs, robots = state.shape[0], state.shape[1]
    neighbours = np.empty((runs, robots, NEIGHBOUR_SIZE))
    for run in range(runs):
        for robot in range(robots):
            row = state[run, robot]
            wrench, pump = vehicles.actuator_wrench[run, robot], vehicles.is_pump[run, robot]
            describe_neighbour(row, wrench, pump, neighbours[run, robot])
    return neighbours
