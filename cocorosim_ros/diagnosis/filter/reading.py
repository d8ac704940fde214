"""Expected readings and their derivatives by the state: one function each, written from the tables of sensors."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import SENSOR_COLUMNS, WATER_WEIGHT
from cocorosim_ros.diagnosis.filter.records import Rates, When
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.errors import changes_of
from cocorosim_ros.world.sensors.sensor_error import TAKEN
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE, YAW, YAW_RATE
from cocorosim_ros.world.terms.blocks import HORIZONTAL, VERTICAL
from cocorosim_ros.world.terms.motors import Motors

Functions = dict[str, Any]


_HEADING = f"row[{YAW}] + when.after * row[{YAW_RATE}]"
_GROUND = f"row[{SURGE}:{HEAVE + 1}]"
_WEIGHT = f", sensor[{SENSOR_COLUMNS.index(WATER_WEIGHT)}]"
_TAKEN = dict(zip(TAKEN, ("row", _HEADING, "water", _GROUND, "motors"), strict=True))


def _numbers(columns: list[int]) -> str:
    return ", ".join(f"sensor[{column}]" for column in columns)


def _expected_lines() -> tuple[list[str], Functions]:
    lines, functions = [], Functions()
    for code, (name, kind) in enumerate(KINDS.items()):
        functions[f"foresee_{code}"] = kind.foresee
        weight = _WEIGHT if kind.by_weight else ""
        lines += [f"if kind == {code}:", f"    shown = truth = foresee_{code}(when, row, rates, water{weight})"]
        for number, (change, columns) in enumerate(changes_of(name)):
            functions[f"shown_{code}_{number}"] = change.foreseen or change.shown
            taken = "".join(f"{_TAKEN[name]}, " for name in change.takes)
            lines.append(f"    shown = shown_{code}_{number}(shown, truth, when.stamp, {taken}{_numbers(columns)})")
        lines.append("    return shown")
    return [*lines, "return math.nan"], {**functions, "math": math}


expected = compile_lines("expected", "kind, when, row, rates, sensor, water, motors", *_expected_lines())
"""Expected reading of a kind, in the unit of the kind; `row` is the state at the grid point, forces behind it.

when: records.When; rates: records.Rates. sensor: the numbers of the errors and of their water, by
layout.SENSOR_COLUMNS. water: velocity through the water (4,), for kinds that are `of_water` alone. motors: of the
robot.
"""


def _sensitivity_lines(upright: bool) -> tuple[list[str], Functions]:
    functions = Functions()
    lines = [f"for column in range({VERTICAL if upright else HORIZONTAL}):", "    seen[column] = 0.0"]
    for code, (name, kind) in enumerate(KINDS.items()):
        if kind.upright != upright:
            continue
        functions[f"sensitivity_{code}"] = kind.sensitivity
        slopes: dict[int, str] = {}
        for number, (change, columns) in enumerate(changes_of(name)):
            if change.slope is not None:
                functions[f"slope_{code}_{number}"] = change.slope
                slopes[number] = f"slope_{code}_{number}(row, {_numbers(columns)})"
        slope = " * ".join(slopes.values()) or "1.0"
        weight = _WEIGHT if kind.by_weight else ""
        lines += [f"if kind == {code}:", f"    sensitivity_{code}(after, row, {slope}, rates, seen{weight})"]
        for number, (change, columns) in enumerate(changes_of(name)):
            if change.aside is not None:
                functions[f"aside_{code}_{number}"] = change.aside
                behind = " * ".join(each for later, each in slopes.items() if later > number) or "1.0"
                lines.append(f"    aside_{code}_{number}(after, row, {behind}, seen, {_numbers(columns)})")
    return lines, functions


_SENSITIVITY = "kind, after, row, sensor, rates, seen"
sensitivity = compile_lines("sensitivity", _SENSITIVITY, *_sensitivity_lines(upright=False))
"""Write the derivative of a horizontal reading by the horizontal state into `seen` (HORIZONTAL,)."""
sensitivity_upright = compile_lines("sensitivity_upright", _SENSITIVITY, *_sensitivity_lines(upright=True))
"""Write the derivative of a vertical reading by the vertical state into `seen` (VERTICAL,)."""


def _asks(name: str, codes: list[int]) -> Any:
    """A compiled function of a kind: whether it is one of these."""
    return compile_lines(name, "kind", ["return " + " or ".join(f"kind == {code}" for code in codes)], {})


_TABLE = list(enumerate(KINDS.values()))
is_upright = _asks("is_upright", [code for code, kind in _TABLE if kind.upright])
"""Tell whether a reading of this kind belongs to the vertical block of the state."""
is_of_water = _asks("is_of_water", [code for code, kind in _TABLE if kind.of_water])
"""Tell whether a reading of this kind depends on the velocity through the water."""
is_angle = _asks("is_angle", [code for code, kind in _TABLE if kind.angle])
"""Tell whether a reading of this kind is an angle."""


@kernel
def deviation(kind: int, value: float, expected: float) -> float:
    """Reading less expectation, angles by the shorter way."""
    difference = value - expected
    if is_angle(kind):
        difference -= 2.0 * math.pi * math.floor(difference / (2.0 * math.pi) + 0.5)
    return difference


@kernel
def certainty_of_turn(kind: int, innovation: float) -> float:
    """Share of its pull that a reading keeps: less beyond a quarter turn, nothing at half a turn; 1 for all but angles.

    Half a turn off, an angle does not tell which way to turn. At full pull the state would leap where a number of the
    model hardly changes, and the likelihood with it (redescending influence: Hampel et al., Robust Statistics, 1986,
    section 2.6).
    """
    left = 2.0 * (1.0 - abs(innovation) / math.pi)
    return left if is_angle(kind) and left < 1.0 else 1.0


class Along(NamedTuple):
    """Moments of a course at which readings are expected."""

    stamps: Floats  # (n,) [s]
    states: Floats  # (n, STATE_SIZE + actuators) states, and forces of the actuators [N]
    water: Floats  # (n, 4) velocities through the water, for kinds that are `of_water` alone


NO_MOTORS = Motors(np.zeros(0, dtype=np.bool_), np.zeros((0, 0)), np.zeros((0, 2)))
"""Motors of a robot for readings that do not feel them."""


@allocating_kernel
def expected_along(kind: int, along: Along, motors: Motors, sensor: Floats, shown: Floats) -> None:
    """Write into `shown` (n,) what readings of one kind show along a course, with the errors of `sensor`."""
    rates = Rates(np.zeros(STATE_SIZE), np.zeros(STATE_SIZE))
    for index in range(len(along.stamps)):
        when = When(along.stamps[index], 0.0, 0.0, 0.0)
        shown[index] = expected(kind, when, along.states[index], rates, sensor, along.water[index], motors)
