"""Effects: equation and numbers of each, and small compiled functions for the places where it acts."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.world.terms.search import Given, Grid, Search, Strength

__all__ = ["SHARE", "Description", "Effect", "Example", "Hook", "Number", "Parameter", "joined_equation"]

Hook = Callable[..., Any]
SHARE = (0.0, 1.0)
"""Between what a share of a whole lies."""


class Example(NamedTuple):
    """A number as it may stand in a platform file: value in SI units, and where it comes from."""

    value: float
    source: str


@dataclass(frozen=True, kw_only=True)
class Number(Parameter):
    """A parameter with its term of the equation, the way it is looked for, and an example.

    The parameter [its unit] times what it `multiplies` [unit] `gives` the term of the equation that it stands in
    [unit]. search: an amplitude, a shape, or what is given; None if no diagnosis looks for it. other_form: standard
    deviation of the number, as a share of it, between causes that follow other laws of the kind than the equation;
    other_place: of a coordinate of a place, as a share of the distance from the robots to that place.
    between: the least and the most that it can be by its meaning: no more than all of the thrust is lost.
    part: what it alone makes of the effect's equation, a sentence of its own or a sum's term with its sign (' + a x').
    """

    gives: str
    multiplies: str = "1"
    search: Strength | Grid | Given | None = None
    example: Example | None = None  # none where a platform file cannot name the effect
    other_form: float = 0.0
    other_place: float = 0.0
    between: tuple[float, float] = (-math.inf, math.inf)
    part: str = ""


@dataclass(frozen=True, kw_only=True)
class Description:
    """Everything that documents, diagnosis and reports say of an effect.

    summary: its name in words, as reports have it. opposite: its name where its first number is negative, "" where
    the summary holds for both signs. equation: in plain text, without the parts that numbers have of their own. check:
    what to look at on the robot or in the tank. search: how a diagnosis looks for it, None if it does not, or not under
    this name.
    """

    summary: str
    parameters: tuple[Parameter, ...]
    opposite: str = ""
    equation: str = ""
    check: str = ""
    search: Search | None = None
    neighbours: bool = False  # whether it looks at other robots (Moment.neighbours) and is nothing without them
    needs: tuple[str, ...] = ()  # what a vehicle must have to show it, names of fitting.vehicle_needs in the diagnosis

    @property
    def numbers(self) -> tuple[Number, ...]:
        """The parameters that are told in full: all but those of laws, whose units depend on the law."""
        return tuple(part for part in self.parameters if isinstance(part, Number))

    @property
    def whole_equation(self) -> str:
        """The equation with the parts of all numbers."""
        return joined_equation(self.equation, [number.part for number in self.numbers])


def joined_equation(always: str, parts: Sequence[str]) -> str:
    """An equation of what always holds and the parts of some numbers; either may be empty."""
    whole = always
    for part in filter(None, parts):
        whole += part if part.startswith((" + ", " - ")) or not whole else f", {part}"
    return whole


@dataclass(frozen=True, kw_only=True)
class Effect(Description):
    """One piece of physics: what it adds, and where.

    `parameters` are its numbers in the order below; `unpack` (compiling.unpacking) gives them their names.
    wrench(row, relative, moment, parameters, total) adds its share to `total` (4,): X, Y, Z [N] and N [N m] in the
    body frame. `row` is one robot's state (state.state), `relative` (4,) its velocity through the water [m/s,
    rad/s; body], `moment` what else there is to know (terms.moment).
    inertia(parameters, inertia) adds to the inertia (4,) against surge, sway, heave [kg] and yaw [kg m^2].
    centre(parameters, place) adds to the place (2,) of the centre of mass, ahead and left of the origin [m; body].
    water(place, time, parameters, total) adds to the water's velocity (3,) [m/s; world] at a place (3,) [m; world].
    command(fraction, fitting, time, parameters) changes the commands (actuators,), fractions, in place.
    thrust(share, fitting, time, parameters) changes what they give (actuators,), as shares of the limits, in place.
    response(force, memory, fitting, duration, parameters) turns the wanted forces (actuators,) [N], which hold for
    `duration` [s], into their mean over that time, in place, and advances the memory (motion.actuation).
    """

    wrench: Hook | None = None
    inertia: Hook | None = None
    centre: Hook | None = None
    water: Hook | None = None
    command: Hook | None = None
    thrust: Hook | None = None
    response: Hook | None = None
