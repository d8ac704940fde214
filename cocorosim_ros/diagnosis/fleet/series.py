"""Numbers of robots over their recordings, with standard deviations taken from their intervals."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fitting.unknowns import deviation, log_deviation
from cocorosim_ros.diagnosis.fleet.rows import Number, Row
from cocorosim_ros.diagnosis.fleet.table import parameters_of
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

WEEK = 7 * 24 * 3600 * NANOSECONDS  # ns


@dataclass(frozen=True)
class Series:
    """One number of one robot in its recordings, by their names.

    weeks (n,): when they were made, since the first dated one of the fleet; NaN where nothing tells it. value, spread
    (n,): the number and its standard deviation; where `relative`, the logarithm of its ratio to the nominal value, so
    that a difference of 0.01 is one percent; else in `unit`.
    """

    robot: str
    parameter: str
    unit: str
    nominal: float
    relative: bool
    recordings: tuple[str, ...]
    weeks: Floats
    value: Floats
    spread: Floats

    def in_unit(self, value: float) -> float:
        """A value, or the end of an interval, as the number itself."""
        return self.nominal * math.exp(value) if self.relative else value

    def off_by(self, difference: float) -> float:
        """The number itself that is off the nominal one by so much, as `value` has it."""
        return self.in_unit(self.aim + difference)

    @property
    def aim(self) -> float:
        """The nominal value, as `value` has it."""
        return 0.0 if self.relative else self.nominal


def series_of(rows: Sequence[Row]) -> tuple[Series, ...]:
    """Gather every number of every robot, by robot and number; those without a finite interval are left out."""
    starts = [row.start_ns for row in rows if row.start_ns is not None]
    first = min(starts, default=0)
    parameters = parameters_of(rows)
    found = []
    signed = {number.parameter for row in rows for number in row.numbers if _is_finite(number) and _is_signed(number)}
    for robot in sorted({row.robot for row in rows if row.robot}):
        mine = [row for row in rows if row.robot == robot]
        for parameter in parameters:
            pairs = [(row, number) for row in mine for number in row.numbers if number.parameter == parameter]
            usable = [(row, number) for row, number in pairs if _is_finite(number)]
            if usable:
                numbers = [number for _, number in usable]
                found.append(_series([row for row, _ in usable], numbers, first, relative=parameter not in signed))
    return tuple(found)


def _series(rows: Sequence[Row], numbers: Sequence[Number], first_ns: int, *, relative: bool) -> Series:
    pairs = [_value(number, relative=relative) for number in numbers]
    weeks = [math.nan if row.start_ns is None else (row.start_ns - first_ns) / WEEK for row in rows]
    return Series(
        rows[0].robot,
        numbers[0].parameter,
        numbers[0].estimate.unit,
        numbers[0].nominal,
        relative,
        tuple(row.recording for row in rows),
        np.array(weeks),
        np.array([value for value, _ in pairs]),
        np.array([spread for _, spread in pairs]),
    )


def _value(number: Number, *, relative: bool) -> tuple[float, float]:
    """Value and standard deviation; intervals of fitted numbers are symmetric in the logarithm."""
    found: Estimate = number.estimate
    if relative:
        return math.log(found.value / number.nominal), log_deviation(found.low, found.high)
    return found.value, deviation(found.low, found.high)


def _is_finite(number: Number) -> bool:
    ends: Iterable[float] = (number.estimate.value, number.estimate.low, number.estimate.high, number.nominal)
    return all(map(math.isfinite, ends)) and number.estimate.high > number.estimate.low


def _is_signed(number: Number) -> bool:
    """Tell whether a number may be zero or negative, so that it has no logarithm."""
    return number.nominal <= 0.0 or number.estimate.low <= 0.0
