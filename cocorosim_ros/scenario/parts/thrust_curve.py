"""How the force of a thruster grows with its command, as a platform file declares it."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.records import choice, quantities, quantity, read_record

_LEAST_POINTS = 2
_SAME = 1e-6  # of the maximum: forces as a table and a maximum say them, perhaps in other units


@dataclass(frozen=True)
class ThrustCurve:
    """Force over command; at command 1 it is the thruster's maximum, at -1 its maximum backwards.

    form: `linear`, `square` (by the signed square of the command, as of a propeller commanded by its rate of turn), or
    `table`. dead_band: the fraction of the command below which there is no force; what is beyond it counts from there.
    commands (ascending fractions), forces [N]: the points of a table, straight in between.
    """

    form: Literal["linear", "square", "table"] = field(metadata=choice("linear", "square", "table"))
    dead_band: float | None = field(default=None, metadata=quantity("pure number", "not negative"))
    commands: tuple[float, ...] | None = field(default=None, metadata=quantities("pure number"))
    forces: tuple[float, ...] | None = field(default=None, metadata=quantities("force"))

    @property
    def points(self) -> tuple[tuple[float, float], ...]:
        """Command and force [N] of each point of a table."""
        return tuple(zip(self.commands or (), self.forces or (), strict=False))


def read_curve(entry: Entry) -> ThrustCurve:
    """The curve that a mapping describes. Raises CocorosimError for one that no command can follow."""
    curve, section = read_record(ThrustCurve, entry), entry.mapping()
    if curve.dead_band is not None and curve.dead_band >= 1.0:
        raise section["dead_band"].problem(f"has {section['dead_band'].found()}; write a fraction below 1.")
    if curve.form != "table":
        for key in ("commands", "forces"):
            if key in section:
                raise section[key].problem(f"belongs to 'form: table', and the form is '{curve.form}'; leave it out.")
        return curve
    if "dead_band" in section:
        raise section["dead_band"].problem("stands beside a table; give the dead band as points of no force instead.")
    _check_points(entry, curve)
    return curve


def _check_points(entry: Entry, curve: ThrustCurve) -> None:
    """Refuse a table whose points do not lie one behind the other, or that pushes without a command."""
    commands, forces = curve.commands or (), curve.forces or ()
    if len(commands) != len(forces) or len(commands) < _LEAST_POINTS:
        raise entry.problem(
            f"has {len(commands)} commands and {len(forces)} forces; a table needs as many of the one as of the other, "
            f"and {_LEAST_POINTS} at least."
        )
    if any(later <= earlier for earlier, later in pairwise(commands)):
        raise entry.problem("has commands that do not ascend; sort the points by command, each once.")
    if commands[0] not in (-1.0, 0.0) or commands[-1] != 1.0:
        raise entry.problem(
            f"has commands from {commands[0]:g} to {commands[-1]:g}; write them from -1 to 1, or from 0 to 1 for a "
            "thruster that pushes forwards only."
        )
    if 0.0 not in commands or forces[commands.index(0.0)] != 0.0:
        raise entry.problem("has no point of force 0 N at command 0; a thruster that is told nothing is off.")
    if any(force * command < 0.0 for command, force in zip(commands, forces, strict=True)):
        raise entry.problem("has a force against its command; forces below command 0 are negative.")


def check_ends(entry: Entry, curve: ThrustCurve, maximum: float, reverse: float) -> None:
    """Refuse a table whose ends are not the thruster's own maxima [N]; entry: the thruster's."""
    if curve.form != "table":
        return
    (first, lowest), (_, highest) = curve.points[0], curve.points[-1]
    least = -lowest if first < 0.0 else 0.0
    for key, told, force in (("maximum", maximum, highest), ("maximum_reverse", reverse, least)):
        if abs(told - force) > _SAME * maximum:
            raise entry.problem(
                f"has the '{key}' {told:g} N, and {force:g} N in the table of its curve; write the same in both."
            )


def check_rising(entry: Entry, thruster: str, curve: ThrustCurve) -> None:
    """Refuse a table whose force falls where its command grows: a force then has several commands.

    entry: what wants the command of a force.
    """
    for (before, force), (after, later) in pairwise(curve.points):
        if later < force:
            raise entry.problem(
                f"takes the thruster '{thruster}', whose force falls from {force:g} N to {later:g} N between the "
                f"commands {before:g} and {after:g}, so that no one command gives a force; correct its table, or write "
                "'form: table'."
            )


def command_for(curve: ThrustCurve | None, share: Floats) -> Floats:
    """The commands (n,) at which a thruster gives shares (n,) of its maxima, -1..1; the curve must not fall anywhere.

    The inverse of world.terms.curve.thrust_share; no force is command 0.
    """
    if curve is None:
        return share
    if curve.form == "table":
        forces = np.array([force for _, force in curve.points])
        shares = forces / np.where(forces < 0.0, -forces[0] or 1.0, forces[-1])
        found = np.interp(share, shares, [command for command, _ in curve.points])
        return np.where(share == 0.0, 0.0, found)
    dead = curve.dead_band or 0.0
    beyond = np.sqrt(np.abs(share)) if curve.form == "square" else np.abs(share)
    return np.sign(share) * (dead + (1.0 - dead) * beyond)
