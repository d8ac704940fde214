"""Axes of the pictures of effects: a quantity of site_builder.circumstances, its words, and how far it reaches."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.effect import Number
from cocorosim_ros.world.terms.regressors import REGRESSOR
from site_builder.lily import lily

POINTS = 241  # along an axis, both ends and the middle among them
REACH, LASTING = 1.0, 600.0  # m and s: how far axes reach where an effect has no length or time of its own
EXTENTS = 3.0  # times the largest length, time or command of an effect that has one


class Axis(NamedTuple):
    """A quantity along an axis: a field of Circumstances, its words, and its values."""

    name: str
    label: str
    unit: str
    meaning: str
    values: Floats  # (POINTS,) [unit]


def axis_of(name: str, numbers: Sequence[Number] = (), amount: bool = False) -> Axis:
    """The axis of a quantity, as far as the `numbers` in its unit want it; `amount`: without its negative half."""
    unit, meaning, label = _OTHER[name] if name in _OTHER else _words(name)
    most = _most(name)
    own = [abs(number.example.value) for number in numbers if number.unit == unit and number.example]
    if (unit in ("m", "s") or name == "command") and any(own):
        most = min(EXTENTS * max(own), 1.0 if name == "command" else math.inf)
    low = 0.0 if amount or name in ("t", "wall_distance", "neighbour_distance") else -most
    high = 0.0 if name == "z" else most
    return Axis(name, label, unit, meaning.partition(", negative")[0], np.linspace(low, high, POINTS))


_OTHER = {
    "side_thrust": ("N", "the force of the thrusters to the left", "sideways thrust"),
    "command": ("1", "the command of all thrusters", "command"),
}


def _words(name: str) -> tuple[str, str, str]:
    regressor = REGRESSOR[name]
    return regressor.unit, regressor.meaning, regressor.label or name.replace("_", " ")


def _most(name: str) -> float:
    """The largest value along an axis."""
    robot = lily()
    own = {"t": LASTING, "yaw": math.pi, "command": 1.0, "r": robot.turning}
    own |= dict.fromkeys(("u", "v", "w"), robot.speed) | dict.fromkeys(("thrust", "side_thrust"), robot.thrust)
    return own.get(name, REACH)
