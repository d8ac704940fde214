"""Steps in time for vehicles in six degrees of freedom: classical fourth-order Runge-Kutta in whole steps."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.motion.actuation import admitted
from cocorosim_ros.world.six_degrees.attitude import bring_to_unit_length
from cocorosim_ros.world.six_degrees.bodies import FIN_LIMIT, Bodies, Body, body_of
from cocorosim_ros.world.six_degrees.dynamics import state_rate
from cocorosim_ros.world.six_degrees.state import ATTITUDE, STATE_SIZE, SURGE


class Steps(NamedTuple):
    """How a stretch of time is cut."""

    begin: float  # s
    count: int
    step: float  # s


class Around(NamedTuple):
    """What is around vehicles, and room for what they do at the moment."""

    flow: Floats  # velocity of the water, see water.flow; empty in still water
    effort: Floats  # (thrusters + fins,) written


@allocating_kernel
def advance(state: Floats, command: Floats, bodies: Bodies, flow: Floats, steps: Steps) -> None:
    """Advance `state` (runs, robots, STATE_SIZE) in place under commands that hold.

    command: (runs, robots, thrusters + fins) fractions of the largest force or angle; beyond -1..1 the limit counts,
    NaN as zero. flow: velocity of the water, see water.flow.
    """
    _advance_all(state, command, bodies, Around(flow, np.empty(command.shape[2])), steps)


@kernel
def _advance_all(state: Floats, command: Floats, bodies: Bodies, around: Around, steps: Steps) -> None:
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            body = body_of(bodies, robot, around.flow)
            set_effort(command[run, robot], body, around.effort)
            for index in range(steps.count):
                take_step(state[run, robot], steps.begin + index * steps.step, steps.step, around.effort, body)


@allocating_kernel
def rates(state: Floats, command: Floats, bodies: Bodies, flow: Floats, time: float, rate: Floats) -> None:
    """Write the derivatives `rate` (runs, robots, STATE_SIZE) of `state` at `time` [s]; the rest as in `advance`."""
    _all_rates(state, command, bodies, Around(flow, np.empty(command.shape[2])), time, rate)


@kernel
def _all_rates(state: Floats, command: Floats, bodies: Bodies, around: Around, time: float, rate: Floats) -> None:
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            body = body_of(bodies, robot, around.flow)
            set_effort(command[run, robot], body, around.effort)
            state_rate(state[run, robot], time, around.effort, body, rate[run, robot])


@kernel
def set_effort(command: Floats, body: Body, effort: Floats) -> None:
    """Write forces of thrusters [N], then angles of fins [rad], for `command` (thrusters + fins,) in -1..1."""
    thrusters = body.limit.shape[0]
    for part in range(thrusters):
        asked = admitted(command[part])
        effort[part] = asked * body.limit[part, 0 if asked >= 0.0 else 1]
    for fin in range(body.fins.shape[0]):
        effort[thrusters + fin] = admitted(command[thrusters + fin]) * body.fins[fin, FIN_LIMIT]


@kernel
def take_step(row: Floats, time: float, step: float, effort: Floats, body: Body) -> None:
    """Advance the state `row` (STATE_SIZE,) from `time` by `step` [s]: classical fourth-order Runge-Kutta."""
    trial, total, rate = stack_array(STATE_SIZE), stack_array(STATE_SIZE), stack_array(STATE_SIZE)
    for column in range(STATE_SIZE):
        trial[column] = row[column]
    moment = time
    for stage in range(4):
        weight = 1.0 if stage == 0 or stage == 3 else 2.0  # noqa: PLR1714
        reach = step if stage == 2 else 0.5 * step
        state_rate(trial, moment, effort, body, rate)
        for column in range(STATE_SIZE):
            total[column] += weight * rate[column]
            trial[column] = row[column] + reach * rate[column]
        moment = time + reach
    for column in range(STATE_SIZE):
        row[column] += step / 6.0 * total[column]
    bring_to_unit_length(row[ATTITUDE:SURGE])
