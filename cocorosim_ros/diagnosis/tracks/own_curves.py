"""Curves of single thrusters by another power of the command, as tables of the simulator.

A thruster whose curve gives the share s(c) of its limit at a command c then gives sign(s) |s|^exponent: the same at
rest and at full command. Exponent 2 makes a square law of a straight line.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import OWN_CURVES
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.curve import FORM, NUMBER, POINTS, TABLE, of_power, thrust_share

_STRAIGHT = np.zeros(POINTS)


def own_curves(curves: Floats, exponents: Floats) -> Floats:
    """Curves (actuators, columns) of `world.terms.curve`, to powers with exponents (actuators,); those of 1 stay."""
    rows = [
        _table(curve if len(curve) else _STRAIGHT, exponent) if exponent != 1.0 else curve
        for curve, exponent in zip(curves, exponents.tolist(), strict=True)
    ]
    found = np.zeros((len(rows), max(len(row) for row in rows)))
    for place, row in enumerate(rows):
        found[place, : len(row)] = row
    return found


def _table(curve: Floats, exponent: float) -> Floats:
    """Table of a power of a curve (columns,)."""
    commands = _commands(curve)
    shares = np.array([of_power(thrust_share(curve, command), exponent) for command in commands.tolist()])
    return np.concatenate([[TABLE, len(commands)], commands, shares])


def _commands(curve: Floats) -> Floats:
    """Commands (n,) of a table, growing: more of them near rest, and those at which the curve (columns,) has a kink."""
    even = np.linspace(-1.0, 1.0, OWN_CURVES.commands)
    number = float(curve[NUMBER])
    kinks = curve[POINTS : POINTS + int(number)] if curve[FORM] == TABLE else np.array([-number, number])
    return np.unique(np.concatenate([even * np.abs(even), kinks]))
