"""Robots of one run that go through the equations of motion together: one after the other, or four in one vector."""

from __future__ import annotations

from typing import Any, NamedTuple

from numba.extending import overload

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.switches import VECTORS
from cocorosim_ros.world.motion.dynamics import basic_rate, state_rate
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.vehicle_model.vehicles import BASIC_BITS, LAW_BITS, Body, Surroundings, Vehicles, body_of


class Group(NamedTuple):
    """Robots of one run with consecutive numbers, of any kind."""

    vehicles: Vehicles
    surroundings: Surroundings
    run: int
    first: int  # number of the first of them
    columns: int  # of their rows at which the equations look


class Fours(NamedTuple):
    """The same, four robots in each number: all with the same basic effects alone, in still water."""

    parameters: Floats  # (fours, BASIC_COLUMNS) of fours
    actuator_wrench: Floats  # (fours, actuators, 4) of fours
    active: int
    columns: int


@kernel
def member(group: Group, place: int) -> Body:
    """The robot at a place of a group, counted from 0."""
    body: Body = body_of(group.vehicles, group.surroundings, group.run, group.first + place)
    return body


def rate_of(group: Any, place: int, row: Floats, time: float, rate: Floats) -> None:
    """Write the time derivative of the state `row` of the robot, or the four robots, at a place of a group.

    Compiled functions alone can call it, with a Group or Fours.
    """


@overload(rate_of, jit_options={"nogil": True, "error_model": "numpy", "forceinline": True})  # type: ignore[untyped-decorator]
def _rate_of(group: Any, place: int, row: Floats, time: float, rate: Floats) -> Any:
    def of_one(group: Any, place: int, row: Floats, time: float, rate: Floats) -> None:
        state_rate(row, time, member(group, place), rate)

    def of_four(group: Any, place: int, row: Floats, time: float, rate: Floats) -> None:
        basic_rate(row, group.parameters[place], group.active, group.actuator_wrench[place], rate)

    return of_one if group.instance_class is Group else of_four


@kernel
def columns_in_use(vehicles: Vehicles, run: int, first: int, rows: Floats) -> int:
    """How many columns of the `rows` (robots, columns) of consecutive robots the equations look at."""
    found = 0
    for place in range(rows.shape[0]):
        found |= vehicles.active[run, first + place]
    # Only a law of no catalogue looks at what actuators remember.
    columns: int = rows.shape[1] if found & LAW_BITS != 0 else STATE_SIZE + vehicles.actuator_wrench.shape[2]
    return columns


@kernel
def is_simple(group: Group, count: int) -> bool:
    """Whether the first `count` of a group have the same basic effects alone and swim in still water.

    None is, where vectors are switched off: robots go through the equations one after the other.
    """
    active = group.vehicles.active[group.run, group.first]
    simple: bool = VECTORS and active & ~BASIC_BITS == 0 and group.surroundings.flow.shape[0] == 0
    for place in range(count):
        simple = simple and group.vehicles.active[group.run, group.first + place] == active
    return simple
