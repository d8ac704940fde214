"""Robots of one run that go through the equations of motion together."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.compilation import kernel, stack_array
from cocorosim_ros.physics.vehicles import BASIC_BITS, Body, Surroundings, Vehicles, body_of


class Group(NamedTuple):
    """Robots of one run with consecutive numbers."""

    vehicles: Vehicles
    surroundings: Surroundings
    run: int
    first: int  # number of the first of them
    allowed: int  # bits of the effects that may act, -1 for all


@kernel
def member(group: Group, place: int) -> Body:
    """The robot at a place of a group, counted from 0."""
    body: Body = body_of(group.vehicles, group.surroundings, group.run, group.first + place)
    return Body(
        body.parameters,
        body.active & group.allowed,
        body.actuator_wrench,
        body.actuator_limit,
        body.is_pump,
        body.flow,
        body.lower,
        body.upper,
        body.neighbours,
        body.own,
    )


@kernel
def is_simple(group: Group, count: int) -> bool:
    """Whether the first `count` of a group have basic effects alone and swim in water whose velocity is zero."""
    found = 0
    for place in range(count):
        found |= group.vehicles.active[group.run, group.first + place]
    simple: bool = found & ~BASIC_BITS == 0 and group.surroundings.flow.shape[0] == 0
    return simple


@kernel
def simplified(group: Group) -> Group:
    """A simple group, written so that the compiler sees that it is one and leaves out what cannot act."""
    surroundings, nothing = group.surroundings, stack_array(1)[:0]
    still = Surroundings(nothing, surroundings.lower, surroundings.upper, surroundings.neighbours)
    return Group(group.vehicles, still, group.run, group.first, BASIC_BITS)
