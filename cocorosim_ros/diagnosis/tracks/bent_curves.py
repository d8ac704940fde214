"""Curves of thrusters that are bent, as tables of the simulator.

A thruster whose curve gives the share s(c) of its limit at a command c gives, bent by b, s (1 + b (|s| - 1)): the same
at rest and at full command, less in between where b is positive. b = 1 makes a square law of a straight line.
Assumes: |b| <= 1, beyond which thrust would not rise with the command.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import BENT_CURVES
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.curve import FORM, NUMBER, POINTS, TABLE, thrust_share

_STRAIGHT = np.zeros(POINTS)


def bent_curves(curves: Floats, bends: Floats) -> Floats:
    """Curves (actuators, columns) of `world.terms.curve`, bent by bends (actuators,) [1]; those with 0 stay."""
    rows = [
        _bent(curve if len(curve) else _STRAIGHT, bend) if bend != 0.0 else curve
        for curve, bend in zip(curves, bends.tolist(), strict=True)
    ]
    found = np.zeros((len(rows), max(len(row) for row in rows)))
    for place, row in enumerate(rows):
        found[place, : len(row)] = row
    return found


def _bent(curve: Floats, bend: float) -> Floats:
    """Table of a bent curve (columns,)."""
    commands = _commands(curve)
    shares = np.array([thrust_share(curve, command) for command in commands.tolist()])
    return np.concatenate([[TABLE, len(commands)], commands, shares * (1.0 + bend * (np.abs(shares) - 1.0))])


def _commands(curve: Floats) -> Floats:
    """Commands (n,) of a table, growing: evenly spaced ones, and those at which the curve (columns,) has a kink."""
    even = np.linspace(-1.0, 1.0, BENT_CURVES.commands)
    number = float(curve[NUMBER])
    kinks = curve[POINTS : POINTS + int(number)] if curve[FORM] == TABLE else np.array([-number, number])
    return np.unique(np.concatenate([even, kinks]))
