"""The numbers of one topic or one kind of file, before anything is known of them; and numbers that were recognised."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.quantity import UNITS


@dataclass(frozen=True)
class LogTable:
    """n rows: `time` (n,) [s], `columns` (n,) each by name; `unnamed` are those that a list holds.

    source: a topic, or a pattern of file names. kind: the type of a topic's messages. where: the entries of the map's
    table beside robot and streams.
    """

    source: str
    kind: str
    time: Floats
    columns: Mapping[str, Floats]
    where: Mapping[str, Any]


@dataclass(frozen=True)
class Number:
    """A number that was recognised: its column, its dimension, the unit in which it stands, and its values there.

    sure: whether the log says the unit, in a name or by its format. negated: whether the map turns its sign.
    quarters: quarter turns that it then adds.
    """

    column: str
    dimension: str
    values: Floats
    unit: str = ""
    sure: bool = False
    negated: bool = False
    quarters: int = 0

    def in_si(self) -> Floats:
        """(n,) the values in SI units."""
        factor = float(Fraction(UNITS[self.dimension][self.unit])) if self.unit else 1.0
        return np.asarray(self.values * factor * (-1.0 if self.negated else 1.0) + self.quarters * math.pi / 2)

    def entry(self) -> dict[str, Any]:
        """Entry of the map for it."""
        unit = {"unit": self.unit} if self.unit and self.dimension != "pure number" else {}
        scale = {"scale": -1} if self.negated else {}
        offset = {"offset": f"{90 * self.quarters} deg"} if self.quarters else {}
        return {"column": self.column, **unit, **scale, **offset}


@dataclass(frozen=True)
class Guess:
    """One stream of the contract that a table holds, with what is doubtful about it.

    north_east_down: whether its axes are, None where nothing told. fixed: numbers that the log does not have.
    """

    table: LogTable
    topic: str
    numbers: Mapping[str, Number]
    north_east_down: bool | None = None
    fixed: Mapping[str, Any] = field(default_factory=dict)
    doubts: tuple[str, ...] = ()

    def doubting(self, *sentences: str) -> Guess:
        """A copy with further doubts."""
        return replace(self, doubts=(*self.doubts, *(sentence for sentence in sentences if sentence)))

    def with_number(self, name: str, number: Number) -> Guess:
        """A copy with another number."""
        return replace(self, numbers={**self.numbers, name: number})

    @property
    def place(self) -> str:
        """Topic or file, and the stream."""
        return f"{self.table.source}, {self.topic}"
