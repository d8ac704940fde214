"""Robots that drift: a number that falls or grows from recording to recording, by more than chance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.fleet import DRIFT
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fleet.regression import Line, fitted_line
from cocorosim_ros.diagnosis.fleet.series import Series
from cocorosim_ros.diagnosis.showing.several_tests import holm
from cocorosim_ros.foundation.arrays import Floats

SLOPE = 1
"""Place of the slope among the coefficients of a line; the value at the middle of the recordings stands first."""


@dataclass(frozen=True)
class Drift:
    """The slope of a number of a robot, by its dated recordings.

    per_week: share of the number gained a week (unit 1; -0.01 is one percent lost), or its own unit where it may be
    zero. scatter: beyond the intervals, in the same measure. chance: p of no drift at all; adjusted: the same for all
    robots and numbers of the fleet together. clear: `adjusted` says that it drifts.
    """

    series: Series  # dated recordings alone
    line: Line
    per_week: Estimate
    scatter: float
    chance: float
    adjusted: float
    clear: bool

    @property
    def span(self) -> float:
        """Weeks between the first and the last recording."""
        return float(np.ptp(self.series.weeks))

    @property
    def middle(self) -> float:
        """The mean of the weeks, at which the line's first coefficient is its value."""
        return float(self.series.weeks.mean())

    def course(self, weeks: Floats) -> tuple[Floats, Floats, Floats]:
        """The line at some weeks (n,), and the ends of its 95 % band, as `series.value` has it."""
        rows = _design(weeks, self.middle)
        mean = rows @ self.line.coefficients
        half = self.line.quantile * np.array([self.line.error(row) for row in rows])
        return mean, mean - half, mean + half


def drifts_of(every: Sequence[Series]) -> tuple[Drift, ...]:
    """Measure the drift of every number that has recordings and dates enough, those that clearly drift first.

    Clearly: by Holm's procedure over all robots and numbers, so that a fleet in which none drifts has one named with a
    probability of DRIFT.sure at most.
    """
    lines = [(each, line) for each in map(_dated, every) if (line := _line(each)) is not None]
    chances = [line.chance(SLOPE) for _, line in lines]
    adjusted = holm(chances)
    found = [
        Drift(each, line, _per_week(each, line), line.scatter, chance, float(p), bool(p <= DRIFT.sure))
        for (each, line), chance, p in zip(lines, chances, adjusted, strict=True)
    ]
    return tuple(sorted(found, key=lambda each: (not each.clear, each.chance)))


def _dated(series: Series) -> Series:
    known = np.isfinite(series.weeks)
    return Series(
        series.robot,
        series.parameter,
        series.unit,
        series.nominal,
        series.relative,
        tuple(name for name, is_known in zip(series.recordings, known, strict=True) if is_known),
        series.weeks[known],
        series.value[known],
        series.spread[known],
    )


def _line(series: Series) -> Line | None:
    if len(series.weeks) < DRIFT.fewest_recordings:
        return None
    return fitted_line(_design(series.weeks, float(series.weeks.mean())), series.value, series.spread)


def _design(weeks: Floats, middle: float) -> Floats:
    return np.column_stack([np.ones_like(weeks), weeks - middle])


def _per_week(series: Series, line: Line) -> Estimate:
    return line.estimate(SLOPE, "1", math.expm1) if series.relative else line.estimate(SLOPE, series.unit)
