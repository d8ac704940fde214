"""Rows of numbers as a file or a topic delivers them, and what becomes of their cells and times."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from decimal import Context, Decimal
from fractions import Fraction
from functools import partial
from typing import Protocol

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.wire.conversion.conversion_map import (
    ColumnValue,
    CommandValue,
    FixedValue,
    MixedValue,
    TimeMap,
    Value,
)
from cocorosim_ros.wire.conversion.formula import Formula
from cocorosim_ros.wire.conversion.run_wise import Number

Stamps = Integers

LATEST_NS = 2**63 - 1
_MOST_DIGITS = 400  # of a time; more would be reckoned with for minutes, digit by digit


class ColumnError(CocorosimError):
    """A column is named that the rows do not have."""


class TopicError(CocorosimError):
    """A topic is named of which the log has no message."""

    def __init__(self, topic: str, sentence: str) -> None:
        super().__init__(sentence)
        self.topic = topic


def no_messages(topic: str, known: Iterable[str], place: Entry, log: str) -> TopicError:
    """The error for a topic without messages; `known` are those that have some."""
    return TopicError(
        topic, str(place.problem(f"names {topic}, which has no message in {log}{nearest(topic, known)}."))
    )


class Rows(Protocol):
    """The rows of one file, or the messages of one topic."""

    origin: str
    count: int
    damage: str
    """A sentence about what is missing from them; empty if nothing is."""

    @property
    def columns(self) -> tuple[str, ...]:
        """The names that columns have, or the paths of fields that are numbers."""

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column; NaN where there is no number. Raises CocorosimError for words."""

    def words(self, column: Entry) -> list[str]:
        """The cells of a column as they stand there."""

    def stamps(self, when: TimeMap) -> tuple[Stamps, Flags]:
        """(n,) times [ns] and whether each is known."""

    def row_name(self, row: int) -> str:
        """The row, counted from 0, as sentences name it."""


def in_si(value: Value, rows: Rows) -> Floats:
    """(n,) a number of the map for every row [SI]; NaN where its cell holds none."""
    if isinstance(value, FixedValue):
        return np.full(rows.count, _settled(value.value))
    if isinstance(value, CommandValue):
        return _fraction(value, rows)
    if isinstance(value, ColumnValue):
        cells = value.column.numbers(rows) if isinstance(value.column, Formula) else rows.numbers(value.column)
        scaled = cells if value.scale == 1.0 else cells * value.scale
        return times_factor(scaled, value.unit_factor) + _settled(value.offset)
    if isinstance(value, MixedValue):
        return np.asarray(sum(weight * in_si(part, rows) for weight, part in value.parts))
    raise TypeError(f"{value} does not stand in a column")


def _settled(number: Number) -> float:
    if isinstance(number, float):
        return number
    raise TypeError("the map was not settled for a recording")


def times_factor(numbers: Floats, factor: str) -> Floats:
    """The numbers in SI; where a unit is a whole part of the SI unit, the nearest double: 57 cm are 0.57 m."""
    parts = 1 / Fraction(factor)
    if parts.denominator == 1 and parts > 1:
        return numbers / float(parts)
    return numbers * float(factor) if factor != "1" else numbers


def _fraction(value: CommandValue, rows: Rows) -> Floats:
    """(n,) the command as a fraction of the maximum; a dead zone about stop stays in it."""
    cells = in_si(value.column, rows)
    ahead = (cells - value.stop) / (value.forward - value.stop)
    if value.reverse is None:
        astern = ahead < 0
        if astern.any():
            found = cells[np.argmax(astern)]
            raise value.place.problem(
                f"finds {found:g} [SI] in {rows.origin}, beyond 'stop' and away from 'forward', but gives no "
                "'reverse'; add it, or correct 'stop'."
            )
        return ahead
    return np.where(ahead < 0, -(cells - value.stop) / (value.reverse - value.stop), ahead)


def time_columns(when: TimeMap, mark: str = ".") -> tuple[tuple[Entry, Callable[[str], int]], ...]:
    """The columns whose sum is the time of a row, each with what makes nanoseconds of its cells.

    mark: what stands before decimals, beside a point.
    """
    if when.clock is not None:
        return ((when.clock.column, partial(when.clock.nanoseconds, mark=mark)),)
    parts = ((when.counter, when.step_ns),) if when.counter is not None and when.step_ns else when.columns
    return tuple((column, partial(exact_nanoseconds, per_unit=per_unit, mark=mark)) for column, per_unit in parts)


def check_times(times: Iterable[int], when: TimeMap, rows: Rows) -> Stamps:
    """(n,) times [ns] with the `start` of their map. Raises CocorosimError for one that no recording can have."""
    shifted = [time + when.start_ns for time in times]
    for row, time in enumerate(shifted):
        if not 0 <= time <= LATEST_NS:
            known = f"a recording lies between 0 s and {LATEST_NS / 1e9:.3g} s"
            way_out = "add 'start' to 'time', or correct its unit"
            if when.clock is not None:
                known += " after 1970 began in UTC"
                way_out = f"correct 'form' ('{when.clock.form}') or 'ahead' of its 'time'"
            raise CocorosimError(
                f"{rows.origin} {rows.row_name(row)} has the time {_seconds_text(time)} s, and {known}; {way_out}."
            )
    return np.array(shifted, dtype=np.int64)


def _seconds_text(nanoseconds: int) -> str:
    """Seconds as text, also those that are too many for a float."""
    try:
        return f"{nanoseconds / 1e9:g}"
    except OverflowError:
        return f"{Context(prec=6).create_decimal(nanoseconds).scaleb(-9).normalize():g}"


def exact_nanoseconds(text: str, per_unit: Fraction, mark: str = ".") -> int:
    """A decimal number of units as whole nanoseconds, rounded; no digit of a long stamp is lost.

    Raises ArithmeticError if the text is no finite number.
    """
    text = text.replace(mark, ".")
    if per_unit.denominator == 1 and text.isdecimal():
        return int(text) * per_unit.numerator
    number = Decimal(text)
    if not number.is_finite() or number.adjusted() > _MOST_DIGITS:
        raise ArithmeticError(text)
    if number.adjusted() < -_MOST_DIGITS:
        return 0
    return round(Fraction(number) * per_unit)
