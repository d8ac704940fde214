"""Drift in fleets whose numbers are drawn: none is named where there is none, and intervals hold the true slope."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fleet.drift import drifts_of
from cocorosim_ros.diagnosis.fleet.rows import rows_of
from cocorosim_ros.diagnosis.fleet.series import series_of
from cocorosim_ros.diagnosis.showing.several_tests import holm

Make = Callable[..., Any]


def drifts(outcomes: Any) -> Any:
    """Drifts of a fleet."""
    return drifts_of(series_of(rows_of(outcomes)))


@pytest.mark.parametrize(("scatter", "weeks"), [(0.0, 5), (0.005, 5), (0.005, 12)])
def test_intervals_hold_the_true_slope(drawn_fleet: Make, scatter: float, weeks: int) -> None:
    """19 times of 20, with and without scatter: of 300 intervals 270 to 297 or more, beyond four deviations of 285."""
    rng = np.random.default_rng([1, weeks])
    found = drifts(drawn_fleet(rng, 100, weeks, scatter=scatter))
    held = sum(each.per_week.holds(0.0) for each in found)
    assert len(found) == 300
    assert 270 <= held  # binomial: 285 +- 3.8; without scatter intervals are too wide rather than too narrow
    if scatter:
        assert held <= 298


def test_fleets_that_do_not_drift(drawn_fleet: Make) -> None:
    """100 fleets of 10 robots and 30 tests, expected are one or fewer with a name; five have a chance of 1 in 300."""
    rng = np.random.default_rng(2)
    named = sum(any(each.clear for each in drifts(drawn_fleet(rng, 10, 6))) for _ in range(100))
    assert named < 5


def test_five_hundred_nominal_recordings_name_none(drawn_fleet: Make) -> None:
    """50 robots in ten weeks."""
    assert not any(each.clear for each in drifts(drawn_fleet(np.random.default_rng(3), 50, 10)))


def test_a_robot_that_loses_thrust_is_found(drawn_fleet: Make) -> None:
    """1 % a week among 50 robots that do not: it alone is named, in its thrust alone; the interval holds 1 %."""
    found = drifts(drawn_fleet(np.random.default_rng(4), 50, 10, loss=0.01))
    (drift,) = [each for each in found if each.clear]
    assert (drift.series.robot, drift.series.parameter) == ("lily_01", "thrust_gain")
    assert drift.per_week.holds(-0.01) and drift.per_week.high < 0.0
    assert drift.scatter == pytest.approx(0.005, rel=0.6)
    assert found[0] is drift
    mean, low, high = drift.course(drift.series.weeks)
    assert np.all((low < mean) & (mean < high))


def test_days_do_not_change_the_slope_and_fewer_recordings_are_not_tested(outcome: Make) -> None:
    """A line of 2 % a week is found exactly from uneven days; three recordings, or undated ones, are no series."""
    days = (0.0, 3.0, 10.0, 31.0)
    made = [outcome(f"r{day}", "a", day, {"drag": (0.02 * day / 7.0, 0.001)}) for day in days]
    made += [outcome(f"b{day}", "b", day, {"drag": (0.0, 0.001)}) for day in days[:3]]
    made += [outcome(f"c{number}", "c", None, {"drag": (0.0, 0.001)}) for number in range(6)]
    (drift,) = drifts(made)
    assert drift.series.robot == "a" and drift.per_week.value == pytest.approx(np.expm1(0.02), rel=1e-9)
    assert drift.span == pytest.approx(31.0 / 7.0, rel=1e-6)


def test_a_number_that_may_be_zero_keeps_its_unit(outcome: Make) -> None:
    """A number whose interval reaches below zero has no logarithm: its drift is in its own unit."""
    made = []
    for week in range(5):
        each = outcome(f"r{week}", "a", 7.0 * week, {"drag": (0.0, 0.1)})
        each.found["numbers"][0] |= {"value": 0.1 + 0.2 * week, "ci95": [-0.1 + 0.2 * week, 0.3 + 0.2 * week]}
        made.append(each)
    (drift,) = drifts(made)
    assert not drift.series.relative
    assert (drift.per_week.value, drift.per_week.unit) == (pytest.approx(0.2), "kg/m")


def test_holm_by_hand() -> None:
    """Three tests: 3 p, then 2 p but no less, then p but no less; a chance of one stays one."""
    assert holm([0.02, 0.01, 0.5]).tolist() == pytest.approx([0.04, 0.03, 0.5])
    assert holm([0.9, 0.8]).tolist() == [1.0, 1.0]
    assert holm([]).tolist() == []
