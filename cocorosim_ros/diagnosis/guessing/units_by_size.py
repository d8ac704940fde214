"""Units that a log does not say, by the size of its numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.checking import ACCELERATIONS, CHECKING
from cocorosim_ros.diagnosis.criteria.guessing import GUESSING
from cocorosim_ros.diagnosis.guessing.log_table import Guess, Number
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.quantity import UNITS, si_unit

_FORCES = ("acceleration_x", "acceleration_y", "acceleration_z")


def with_units(guess: Guess) -> Guess:
    """Every number with a unit; for each dimension whose unit nothing says a doubt."""
    felt = _acceleration_unit(guess)
    numbers: dict[str, Number] = {}
    told: dict[tuple[str, str], list[str]] = {}
    for name, number in guess.numbers.items():
        unit = number.unit or (felt if name in _FORCES else _UNITS.get(number.dimension, _si)(number))
        numbers[name] = replace(number, unit=unit)
        if not number.unit and number.dimension != "pure number":
            told.setdefault((number.dimension, unit), []).append(number.column)
    doubts = [
        f"Nothing says the unit of {', '.join(columns)}; by size it is taken to be {unit}."
        for (_, unit), columns in told.items()
    ]
    return replace(guess, numbers=numbers).doubting(*doubts)


def _si(number: Number) -> str:
    return si_unit(number.dimension)


def _largest(values: Floats) -> float:
    return float(np.nanmax(np.abs(values), initial=0.0))


def _angle(number: Number) -> str:
    return "deg" if _largest(number.values) > GUESSING.full_turn else "rad"


def _rate(number: Number) -> str:
    return "deg/s" if _largest(number.values) > GUESSING.fast_turn else "rad/s"


def _pressure(number: Number) -> str:
    usual = float(np.nanmedian(number.values))
    least, most = CHECKING.smallest_air, CHECKING.largest_pressure
    fitting = [unit for unit, factor in UNITS["pressure"].items() if least <= usual * float(factor) <= most]
    return fitting[0] if fitting else "Pa"


_UNITS: dict[str, Callable[[Number], str]] = {"angle": _angle, "angular velocity": _rate, "pressure": _pressure}


def _acceleration_unit(guess: Guess) -> str:
    """Unit of an acceleration by gravity, which is a part of what an accelerometer shows."""
    felt = [guess.numbers[name].values for name in _FORCES if name in guess.numbers]
    if not felt:
        return "m/s^2"
    size = float(np.nanmedian(np.linalg.norm(felt, axis=0)))
    low, high = ACCELERATIONS["g"]
    return "g0" if low <= size <= high else "m/s^2"
