"""Commands of actuators: columns and topics that they stand in, their units, and the ends of their ranges."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.guessing import GUESSING
from cocorosim_ros.diagnosis.guessing.column_names import Meaning
from cocorosim_ros.diagnosis.guessing.log_table import Guess, LogTable, Number
from cocorosim_ros.diagnosis.guessing.recognising import meanings
from cocorosim_ros.foundation.arrays import Floats

COMMAND = "thruster_command"
_PULSE = {"unit": "us", "stop": "1500 us", "forward": "1900 us", "reverse": "1100 us"}
_PX4 = re.compile(r"actuator_(motors|outputs|servos)")
_UNIT_WORDS = {"rpm": "rpm", "rps": "rev/s", "torque": "N m", "force|thrust|wrench": "N", "rudder|rad": "rad"}
_WRENCH = {"force.x": "ahead", "force.y": "left", "force.z": "up", "torque.z": "turn"}


def commands_of(table: LogTable) -> Iterator[Guess]:
    """The commands in a table, if it has any that change; those that stand still are said."""
    found = dict(_columns(table))
    moving = {name: column for name, column in found.items() if _moves(table.columns[column])}
    if not moving:
        return
    numbers = {name: Number(column, "pure number", table.columns[column]) for name, column in moving.items()}
    told = {name: _limits(column, table.columns[column]) for name, column in moving.items()}
    doubts: dict[str, list[str]] = {}
    for name, (_, words) in told.items():
        doubts.setdefault(words, []).append(f"'{moving[name]}'")
    still = [f"'{column}'" for name, column in found.items() if name not in moving]
    sentences = [f"{', '.join(columns)}: {words}" for words, columns in doubts.items()]
    sentences += [f"{', '.join(still)}: the same all the time, so left out."] if still else []
    yield replace(Guess(table, COMMAND, numbers), fixed={name: limits for name, (limits, _) in told.items()}).doubting(
        *sentences
    )


def _columns(table: LogTable) -> Iterator[tuple[str, str]]:
    """The actuators of a table with their columns; names as a map may have them."""
    if table.kind == "px4" and not _PX4.match(table.source):
        return
    wrench = {column: name for end, name in _WRENCH.items() for column in table.columns if column.endswith(end)}
    if len(wrench) > 1:
        yield from ((name, column) for column, name in wrench.items())
        return
    told = meanings(table)
    columns = [name for name in table.columns if _PX4.match(table.source) or _is_command(told, name)]
    names = _short([_name(table, column) for column in columns])
    yield from zip(names, columns, strict=True)


def _is_command(told: dict[str, Meaning], column: str) -> bool:
    return column in told and told[column].stream == COMMAND


def _name(table: LogTable, column: str) -> str:
    """A name of an actuator: the topic's words for a message with one number, or the column's."""
    bare = column.replace("data", "") if table.kind else column
    words = f"{table.source}_{bare}" if table.kind and table.kind != "px4" else bare
    return "_".join(re.findall(r"[A-Za-z0-9]+", words)) or "actuator"


def _short(names: Sequence[str]) -> list[str]:
    """The names without the words that all begin and end with, a letter first."""
    parts = [name.split("_") for name in names]
    while len(parts) > 1 and all(len(each) > 1 for each in parts) and len({each[0] for each in parts}) == 1:
        parts = [each[1:] for each in parts]
    while len(parts) > 1 and all(len(each) > 1 for each in parts) and len({each[-1] for each in parts}) == 1:
        parts = [each[:-1] for each in parts]
    short = ["_".join(each) for each in parts]
    return [name if not name[0].isdigit() else f"actuator_{name}" for name in short]


def together(guesses: Sequence[Guess]) -> list[Guess]:
    """Commands with short names where each actuator has a topic of its own, and no name twice."""
    names = [(guess, name) for guess in guesses for name in guess.numbers]
    short = _short([name for _, name in names]) if len(names) > 1 else ["thruster" for _ in names]
    renamed = iter(short if len(set(short)) == len(short) else [name for _, name in names])
    new = {(id(guess), name): next(renamed) for guess, name in names}
    return [
        replace(
            guess,
            numbers={new[id(guess), name]: number for name, number in guess.numbers.items()},
            fixed={new[id(guess), name]: limits for name, limits in guess.fixed.items()},
        )
        for guess in guesses
    ]


def _moves(values: Floats) -> bool:
    known = values[np.isfinite(values)]
    return bool(known.size) and float(np.ptp(known)) > GUESSING.standing * max(1.0, float(np.abs(known).max()))


def _limits(column: str, values: Floats) -> tuple[dict[str, object], str]:
    """Entries of a map for a command: unit, stop, full ahead and astern; and a sentence about what is doubtful."""
    known = values[np.isfinite(values)]
    if ((known > GUESSING.pulse_low) & (known < GUESSING.pulse_high)).all():
        return dict(_PULSE), "taken for servo pulses, of which 1500 us is stop, and 1100 and 1900 us are the ends."
    reach = float(np.abs(known).max())
    most = 1.0 if reach <= 1.0 else _round_above(reach)
    unit = next((unit for words, unit in _UNIT_WORDS.items() if re.search(words, column.lower())), "1")
    shown = "" if unit == "1" else f" {unit}"
    ends = {"stop": 0.0, "forward": most, "reverse": -most}
    limits = {name: f"{value:g}{shown}" if shown else value for name, value in ends.items()}
    if reach <= 1.0 and unit == "1":
        return {"unit": unit, **limits}, "taken as a fraction of full power."
    words = f"which value is full power is not known; {most:g}{shown} lies above all that was asked for."
    return {"unit": unit, **limits}, words


def _round_above(value: float) -> float:
    """The least of 1, 2, 5 times a power of ten that is not below."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= value)
