"""A single robot under given commands in open water, without sensors and controllers."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.motion.contact import INELASTIC
from cocorosim_ros.world.motion.integrators import INTEGRATOR_CODE
from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
from cocorosim_ros.world.state.state import YAW, X, row_size
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.vehicles import Vehicles
from cocorosim_ros.world.water.flow import make_flow

STILL = make_flow([])
OPEN_WATER = Tank(np.full(3, -1e9), np.full(3, 1e9), np.zeros((0, 4)), np.zeros((0, 6)))


class Stepper(NamedTuple):
    """How time is stepped: the name of an integrator and its longest step [s]."""

    integrator: str
    longest_step: float


ACCURATE = Stepper("rk4", 0.05)
PAPER = Stepper("semi_implicit_euler", 0.5)  # Read et al. 2013


def free_run(vehicles: Vehicles, start: Floats, moments: Floats, commands: Floats, stepper: Stepper) -> Floats:
    """(len(moments), 4) x, y, z [m; world] and yaw [rad, not wrapped] at each moment.

    `vehicles` (one run, one robot) starts at rest at `start` (4,) at the first of `moments` [s, ascending];
    `commands` (len(moments), actuators), fractions, hold from their moment to the next.
    """
    actuators = vehicles.actuator_limit.shape[2]
    state = np.zeros((1, 1, row_size(actuators)))
    state[0, 0, X : YAW + 1] = start
    path = np.empty((len(moments), 4))
    path[0] = start
    for index, interval in enumerate(np.diff(moments)):
        apply_commands(state, np.ascontiguousarray(commands[None, None, index]), vehicles)
        steps = max(1, math.ceil(interval / stepper.longest_step - 1e-9))
        code = INTEGRATOR_CODE[stepper.integrator]
        move(state, vehicles, OPEN_WATER, Stepping(code, steps, interval / steps, INELASTIC), STILL, 0.0)
        path[index + 1] = state[0, 0, X : YAW + 1]
    return path


def constant_run(
    vehicles: Vehicles, command: tuple[float, ...], duration: float, stepper: Stepper
) -> tuple[Floats, Floats]:
    """Moments [s] and path (n, 4) from rest at the origin under one command, a moment per step of the stepper."""
    moments: Floats = np.arange(round(duration / stepper.longest_step) + 1, dtype=np.float64) * stepper.longest_step
    commands = np.tile(command, (len(moments), 1))
    return moments, free_run(vehicles, np.zeros(4), moments, commands, stepper)


def moment_of(moments: Floats, values: Floats, target: float) -> float:
    """When ascending `values` pass `target`, by a straight line between two moments."""
    return float(np.interp(target, values, moments))
