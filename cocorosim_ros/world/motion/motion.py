"""One tick of motion for all robots of all runs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, in_fours
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.world.motion.actuation import ACTUATION_BITS, actuate, admitted
from cocorosim_ros.world.motion.contact import keep_in_tank
from cocorosim_ros.world.motion.group import Group, columns_in_use, is_simple, member
from cocorosim_ros.world.motion.integrators import take_step
from cocorosim_ros.world.motion.obstacle_contact import keep_out_of_obstacles
from cocorosim_ros.world.motion.packing import (
    FOURS,
    SCRATCH_ROWS,
    SIDE_BY_SIDE,
    Space,
    fours_of,
    in_lanes,
    lanes_to_rows,
    rows_to_lanes,
)
from cocorosim_ros.world.motion.surroundings import look_around
from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE
from cocorosim_ros.world.vehicle_model.vehicles import BASIC_COLUMNS, Surroundings, Vehicles, as_runs, body_of


class Bounds(NamedTuple):
    """The tank, and what is around robots in it."""

    tank: Tank
    surroundings: Surroundings


class Stepping(NamedTuple):
    """How a tick is cut into steps."""

    integrator: int  # INTEGRATOR_CODE
    steps: int  # per tick
    step: float  # s
    contact: int  # CONTACT_CODE


@allocating_kernel
def apply_commands(state: Floats, command: Floats, vehicles: Vehicles) -> None:
    """Set the commands in `state` from `command` (runs, robots, actuators), fractions in -1..1, and what forces they
    give where these hold for the whole tick.

    What lies beyond counts as the limit, NaN as zero: an actuator that was told nothing is off.
    """
    nowhere = Surroundings(np.empty(0), np.empty(3), np.empty(3), np.empty((1, 0, NEIGHBOUR_SIZE)))
    _apply_all(state, command, vehicles, nowhere)


@kernel
def _apply_all(state: Floats, command: Floats, vehicles: Vehicles, nowhere: Surroundings) -> None:
    actuators = command.shape[2]
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            force, kept, memory = actuator_columns(state[run, robot], actuators)
            for actuator in range(actuators):
                kept[actuator] = admitted(command[run, robot, actuator])
            body = body_of(vehicles, nowhere, run, robot)
            if body.active & ACTUATION_BITS == 0:
                actuate(kept, memory, body, Interval(0.0, 0.0), force)


@allocating_kernel
def move(state: Floats, vehicles: Vehicles, tank: Tank, stepping: Stepping, flow: Floats, time: float) -> None:
    """Advance `state` (runs, robots, columns) in place by one tick that begins at `time` [s].

    The commands in `state` (see `apply_commands`) hold for the tick; `flow` is the velocity of the water.
    """
    surroundings = Surroundings(flow, tank.lower, tank.upper, look_around(state, vehicles))
    actuators = vehicles.actuator_wrench.shape[2]
    space = Space(
        np.empty((SCRATCH_ROWS, SIDE_BY_SIDE, state.shape[2])),
        np.empty((1 + SCRATCH_ROWS, FOURS, STATE_SIZE + actuators, LANES)),
        np.empty((FOURS, BASIC_COLUMNS, LANES)),
        np.empty((FOURS, actuators, 4, LANES)),
    )
    _move_all(state, vehicles, Bounds(tank, surroundings), stepping, time, space)


@kernel
def actuator_columns(row: Floats, actuators: int) -> tuple[Floats, Floats, Floats]:
    """Views of a robot's row: forces (actuators,), commands (actuators,), memory (MEMORY_SIZE * actuators,)."""
    first, second = STATE_SIZE + actuators, STATE_SIZE + 2 * actuators
    return row[STATE_SIZE:first], row[first:second], row[second:]


@kernel
def _move_all(state: Floats, vehicles: Vehicles, bounds: Bounds, stepping: Stepping, time: float, space: Space) -> None:
    tank, surroundings = bounds
    runs, robots = state.shape[0], state.shape[1]
    if surroundings.neighbours.shape[1] == 0:
        # Nobody looks at others, so that robots of different runs can fill a group as if they were of one run.
        runs, robots = 1, runs * robots
    swarms, members = state.reshape(runs, robots, state.shape[2]), as_runs(vehicles, runs, robots)
    for run in range(runs):
        for first in range(0, robots, SIDE_BY_SIDE):
            rows = swarms[run, first : min(first + SIDE_BY_SIDE, robots)]
            group = Group(members, surroundings, run, first, columns_in_use(members, run, first, rows))
            if is_simple(group, rows.shape[0]):
                _move_simple_group(rows, group, tank, stepping, time, space)
            else:
                _move_group(rows, group, tank, stepping, time, space.scratch)


@kernel
def _move_simple_group(rows: Floats, group: Group, tank: Tank, stepping: Stepping, time: float, space: Space) -> None:
    """A tick of a group without anything beyond the basics, four robots at a time. All forces hold for the tick."""
    fours, many = in_lanes(group, rows.shape[0], space), fours_of(rows.shape[0])
    spaces = in_fours(space.rows)
    rows_to_lanes(rows, group.columns, spaces[0])
    for step in range(stepping.steps):
        if step > 0:
            rows_to_lanes(rows, STATE_SIZE, spaces[0])
        now = time + step * stepping.step
        take_step(stepping.integrator, spaces[0, :many], now, stepping.step, fours, spaces[1:])
        lanes_to_rows(spaces[0], rows)
        _keep_in_water(rows, tank, stepping.contact)


@kernel
def _move_group(rows: Floats, group: Group, tank: Tank, stepping: Stepping, time: float, scratch: Floats) -> None:
    """A tick of a group. Forces that change within it are taken anew every step, and at its end for who measures."""
    for step in range(stepping.steps):
        now = time + step * stepping.step
        _actuate_all(rows, group, Interval(now, stepping.step))
        take_step(stepping.integrator, rows, now, stepping.step, group, scratch)
        _keep_in_water(rows, tank, stepping.contact)
    _actuate_all(rows, group, Interval(time + stepping.steps * stepping.step, 0.0))


@kernel
def _keep_in_water(rows: Floats, tank: Tank, contact: int) -> None:
    for robot in range(rows.shape[0]):
        keep_out_of_obstacles(rows[robot], tank, contact)
        keep_in_tank(rows[robot], tank, contact)


@kernel
def _actuate_all(rows: Floats, group: Group, interval: Interval) -> None:
    """Bring the forces that change within a tick to an interval."""
    for robot in range(rows.shape[0]):
        body = member(group, robot)
        if body.active & ACTUATION_BITS != 0:
            force, command, memory = actuator_columns(rows[robot], body.actuator_wrench.shape[0])
            actuate(command, memory, body, interval, force)
