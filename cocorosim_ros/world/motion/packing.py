"""A group of robots whose motion is simple, written four robots to a number, and back."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, four, four_at, in_fours, put_four_at
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.shuffled import transposed
from cocorosim_ros.world.motion.group import Fours, Group
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.vehicle_model.vehicles import BASIC_COLUMNS

SIDE_BY_SIDE = 12  # robots of a group
FOURS = SIDE_BY_SIDE // LANES
SCRATCH_ROWS = 2  # of an integrator


class Space(NamedTuple):
    """Where the numbers of a group are kept while it moves; the last axis of the later ones is that of four robots."""

    scratch: Floats  # (SCRATCH_ROWS, SIDE_BY_SIDE, columns)
    rows: Floats  # (1 + SCRATCH_ROWS, FOURS, STATE_SIZE + actuators, LANES)
    parameters: Floats  # (FOURS, BASIC_COLUMNS, LANES)
    actuator_wrench: Floats  # (FOURS, actuators, 4, LANES)


@kernel
def rows_to_lanes(rows: Floats, columns: int, fours: Floats) -> None:
    """Write the first columns of `rows` (robots, columns) into `fours` (fours, columns).

    The last robot fills the lanes that are left.
    """
    whole = columns - columns % LANES
    for place in range(fours_of(rows.shape[0])):
        a, b, c, d = _robots_of(place, rows.shape[0])
        for at in range(0, whole, LANES):
            block = transposed(four_at(rows[a], at), four_at(rows[b], at), four_at(rows[c], at), four_at(rows[d], at))
            for lane in range(LANES):
                fours[place, at + lane] = block[lane]
        for column in range(whole, columns):
            fours[place, column] = four(rows[a, column], rows[b, column], rows[c, column], rows[d, column])


@kernel
def lanes_to_rows(fours: Floats, rows: Floats) -> None:
    """Write the states of `fours` (fours, columns) into `rows` (robots, columns)."""
    for place in range(fours_of(rows.shape[0])):
        robots = _robots_of(place, rows.shape[0])
        for at in range(0, STATE_SIZE, LANES):
            block = transposed(fours[place, at], fours[place, at + 1], fours[place, at + 2], fours[place, at + 3])
            for lane in range(LANES):
                put_four_at(rows[robots[lane]], at, block[lane])


@kernel
def in_lanes(group: Group, count: int, space: Space) -> Fours:
    """The first `count` of a simple group as fours, which are kept in `space`."""
    vehicles, run, first, last = group.vehicles, group.run, group.first, group.first + count
    parameters, wrench = in_fours(space.parameters), in_fours(space.actuator_wrench)
    rows_to_lanes(vehicles.parameters[run, first:last], BASIC_COLUMNS, parameters)
    for actuator in range(wrench.shape[1]):
        rows_to_lanes(vehicles.actuator_wrench[run, first:last, actuator], wrench.shape[2], wrench[:, actuator])
    return Fours(parameters, wrench, vehicles.active[run, first], group.columns)


@kernel
def fours_of(robots: int) -> int:
    """How many fours so many robots fill, the last one perhaps in part."""
    return (robots + LANES - 1) // LANES


@kernel
def _robots_of(place: int, count: int) -> tuple[int, int, int, int]:
    """The robots in the lanes of a four, of `count` ones."""
    first, last = LANES * place, count - 1
    return first, min(first + 1, last), min(first + 2, last), min(first + 3, last)
