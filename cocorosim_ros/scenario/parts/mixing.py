"""What a platform says of sticks: commands along and about six axes, which become those of its actuators."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Literal

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.allocation import check_rank, wrench_of
from cocorosim_ros.scenario.parts.six_degrees import AXES
from cocorosim_ros.scenario.parts.steering import Azimuth
from cocorosim_ros.scenario.parts.thrust_curve import check_rising
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator, Thruster
from cocorosim_ros.scenario.reading.entry import Entry, listed, nearest
from cocorosim_ros.scenario.reading.records import TEXT, choice, list_of, nested, quantity, vector

_FORCE, _TORQUE = quantity("force", "positive"), quantity("torque", "positive")
_Amount = float | None


@dataclass(frozen=True)
class FullSticks:
    """What each stick asks for at its end: forces [N] and torques [N m; body], None where there is no such stick."""

    surge: _Amount = field(default=None, metadata=_FORCE)
    sway: _Amount = field(default=None, metadata=_FORCE)
    heave: _Amount = field(default=None, metadata=_FORCE)
    roll: _Amount = field(default=None, metadata=_TORQUE)
    pitch: _Amount = field(default=None, metadata=_TORQUE)
    yaw: _Amount = field(default=None, metadata=_TORQUE)

    @property
    def amounts(self) -> dict[str, float]:
        """The sticks that there are, in the order of AXES, with what each asks for."""
        given = {each.name: getattr(self, each.name) for each in fields(self)}
        return {name: amount for name, amount in given.items() if amount is not None}


@dataclass(frozen=True)
class MixingRow:
    """What one actuator gets of all sticks.

    weights: the command, a fraction, that each stick at its end gives it, in the order of AXES.
    """

    actuator: str = field(metadata=TEXT)
    weights: tuple[float, ...] = field(metadata=vector("pure number", len(AXES)))


@dataclass(frozen=True)
class Mixing:
    """How sticks, -1..1 along and about the body axes forward-left-up, become commands of actuators.

    form: `table`, whose rows say what every actuator gets; or `allocation`: the smallest forces of the thrusters, by
    place, direction, limits and curve as this file gives them, that make the force or torque which each stick asks for.
    """

    form: Literal["table", "allocation"] = field(metadata=choice("table", "allocation"))
    rows: tuple[MixingRow, ...] | None = field(default=None, metadata=list_of(MixingRow))
    full_sticks: FullSticks | None = field(default=None, metadata=nested(FullSticks))

    @property
    def sticks(self) -> tuple[str, ...]:
        """The sticks that do something, in the order of AXES."""
        if self.form == "allocation":
            return tuple((self.full_sticks or FullSticks()).amounts)
        return tuple(axis for place, axis in enumerate(AXES) if any(row.weights[place] for row in self.rows or ()))


def mixed_thrusters(actuators: Sequence[Actuator]) -> list[Thruster]:
    """The thrusters that an allocation uses: those that keep their direction."""
    turned = {part.thruster for part in actuators if isinstance(part, Azimuth)}
    return [part for part in actuators if isinstance(part, Thruster) and part.name not in turned]


def allocation_matrix(mixing: Mixing, actuators: Sequence[Actuator]) -> Floats:
    """(sticks, thrusters) what one newton of each thruster of `mixed_thrusters` gives along or about each stick."""
    columns = [wrench_of(part) for part in mixed_thrusters(actuators)]
    axes = [AXES.index(stick) for stick in mixing.sticks]
    return np.array(columns).reshape(-1, len(AXES)).T[axes]


def table_matrix(mixing: Mixing) -> Floats:
    """(sticks, rows) the command of the actuator of each row per stick."""
    axes = [AXES.index(stick) for stick in mixing.sticks]
    return np.array([row.weights for row in mixing.rows or ()]).reshape(-1, len(AXES)).T[axes]


def check_mixing(entry: Entry, mixing: Mixing, actuators: Sequence[Actuator]) -> None:
    """Nothing, if sticks can drive these actuators so; entry: the mixing's. Raises CocorosimError otherwise."""
    section = entry.mapping()
    own, other = ("rows", "full_sticks") if mixing.form == "table" else ("full_sticks", "rows")
    if own not in section:
        raise entry.problem(f"lacks '{own}', which 'form: {mixing.form}' needs; add it.")
    if other in section:
        raise section[other].problem(f"does not belong to 'form: {mixing.form}'; leave it out.")
    if mixing.form == "table":
        _check_rows(section["rows"], mixing, [part.name for part in actuators])
        matrix = table_matrix(mixing)
    else:
        _check_curves(section[own], actuators)
        matrix = allocation_matrix(mixing, actuators)
    if not mixing.sticks:
        raise section[own].problem(f"names no stick; give one of {listed(AXES)} something to do.")
    check_rank(matrix, mixing.sticks, section[own])
    for part in actuators:
        if part.name in mixing.sticks:
            raise entry.problem(f"has the stick '{part.name}', and an actuator is called so too; rename the actuator.")


def _check_rows(section: Entry, mixing: Mixing, names: Sequence[str]) -> None:
    met: list[str] = []
    for entry, row in zip(section.items(), mixing.rows or (), strict=True):
        place = entry.mapping()["actuator"]
        if row.actuator not in names:
            raise place.problem(
                f"has '{row.actuator}', which is no actuator of this platform{nearest(row.actuator, names)}."
            )
        if row.actuator in met:
            raise place.problem(f"has '{row.actuator}' a second time; give each actuator one row.")
        met.append(row.actuator)


def _check_curves(section: Entry, actuators: Sequence[Actuator]) -> None:
    """Refuse thrusters for whose force there is no one command."""
    for part in mixed_thrusters(actuators):
        if part.curve is not None:
            check_rising(section, part.name, part.curve)
