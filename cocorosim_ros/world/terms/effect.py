"""What an effect is: its parameters, and small compiled functions for the places where it acts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.scenario.parts.parameter import Parameter

__all__ = ["Effect", "Hook", "Parameter"]

Hook = Callable[..., Any]


@dataclass(frozen=True)
class Effect:
    """One piece of physics: what it adds, and where. `parameters` are this effect's numbers, in the order below.

    wrench(row, relative, moment, parameters, total) adds its share to `total` (4,): X, Y, Z [N] and N [N m] in the
    body frame. `row` is one robot's state (state.state), `relative` (4,) its velocity through the water [m/s,
    rad/s; body], `moment` what else there is to know (terms.moment).
    inertia(parameters, inertia) adds to the inertia (4,) against surge, sway, heave [kg] and yaw [kg m^2].
    water(place, time, parameters, total) adds to the water's velocity (3,) [m/s; world] at a place (3,) [m; world].
    command(fraction, fitting, time, parameters) changes the commands (actuators,), fractions, in place.
    response(force, memory, fitting, duration, parameters) turns the wanted forces (actuators,) [N], which hold for
    `duration` [s], into their mean over that time, in place, and advances the memory (motion.actuation).
    """

    summary: str
    parameters: tuple[Parameter, ...]
    wrench: Hook | None = None
    inertia: Hook | None = None
    water: Hook | None = None
    command: Hook | None = None
    response: Hook | None = None
