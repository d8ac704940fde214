"""Effects of nearly all recordings of a fleet, and shifts of the platform's numbers in nearly all robots."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.fleet import COMMON, DRIFT
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fitting.unknowns import deviation
from cocorosim_ros.diagnosis.fleet.regression import Line, fitted_line
from cocorosim_ros.diagnosis.fleet.rows import Effect, Row
from cocorosim_ros.diagnosis.fleet.series import Series
from cocorosim_ros.diagnosis.showing.several_tests import holm
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class CommonEffect:
    """An effect of nearly all recordings of robots that could show it.

    found, able: how many have it, and how many could show it; confirmed: of those that have it. parameters: its numbers
    pooled over the recordings, with their scatter in the intervals.
    """

    id: str
    found: int
    able: int
    confirmed: int
    parameters: dict[str, Estimate]


@dataclass(frozen=True)
class CommonShift:
    """A number of the platform that is off in the same direction in nearly all robots.

    pooled: the mean over robots, in its own unit. scatter: between robots, a share where the number is relative.
    """

    parameter: str
    nominal: float
    pooled: Estimate
    scatter: float
    robots: int
    same_side: int


@dataclass(frozen=True)
class InCommon:
    """Effects and shifts that are common to all."""

    effects: tuple[CommonEffect, ...]
    shifts: tuple[CommonShift, ...]


def in_common(rows: Sequence[Row], every: Sequence[Series]) -> InCommon:
    """Find effects of nearly all rows, and numbers that have moved to the same side in nearly all robots."""
    told = [row for row in rows if row.diagnosed and row.verdict != "insufficient"]
    names = sorted({each.id for row in told for each in row.effects})
    effects = [found for name in names if (found := _effect(name, told)) is not None]
    return InCommon(tuple(effects), _shifts(every) if len(told) >= COMMON.fewest else ())


def _effect(name: str, rows: Sequence[Row]) -> CommonEffect | None:
    found = [each for row in rows for each in row.effects if each.id == name]
    able = sum(name not in row.not_shown for row in rows)
    if len(found) < max(COMMON.fewest, COMMON.nearly_all * able):
        return None
    parameters = dict.fromkeys(part for each in found for part in each.parameters)
    pooled = {part: estimate for part in parameters if (estimate := _pooled(part, found)) is not None}
    return CommonEffect(name, len(found), able, sum(each.tier == "confirmed" for each in found), pooled)


def _pooled(parameter: str, found: Sequence[Effect]) -> Estimate | None:
    numbers = [each.parameters[parameter] for each in found if parameter in each.parameters]
    known = [each for each in numbers if math.isfinite(each.low + each.high) and each.high > each.low]
    value = np.array([each.value for each in known])
    line = _mean(value, np.array([deviation(each.low, each.high) for each in known]))
    return None if line is None else line.estimate(0, known[0].unit)


def _mean(value: Floats, spread: Floats) -> Line | None:
    return fitted_line(np.ones((len(value), 1)), value, spread)


def _shifts(every: Sequence[Series]) -> tuple[CommonShift, ...]:
    found, chances = [], []
    for parameter in dict.fromkeys(each.parameter for each in every):
        mine = [each for each in every if each.parameter == parameter]
        off, spread = _of_robots(mine)
        line = _mean(off, spread)
        if line is None:
            continue
        sides = np.sign(off)
        same = int(max(np.count_nonzero(sides > 0), np.count_nonzero(sides < 0)))
        pooled = line.estimate(0, mine[0].unit, mine[0].off_by)
        found.append(CommonShift(parameter, mine[0].nominal, pooled, line.scatter, len(off), same))
        chances.append(line.chance(0))
    adjusted = holm(chances)
    return tuple(
        each
        for each, p in zip(found, adjusted, strict=True)
        if p <= DRIFT.sure and each.same_side >= COMMON.nearly_all * each.robots
    )


def _of_robots(mine: Sequence[Series]) -> tuple[Floats, Floats]:
    """Differences from the nominal value of each robot, and their standard deviations; of one alone each recording."""
    if len(mine) == 1:
        return mine[0].value - mine[0].aim, mine[0].spread
    off, spread = [], []
    for each in mine:
        line = _mean(each.value, each.spread)
        off.append((each.value[0] if line is None else float(line.coefficients[0])) - each.aim)
        spread.append(each.spread[0] if line is None else math.sqrt(float(line.covariance[0, 0])))
    return np.array(off), np.array(spread)
