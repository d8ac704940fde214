"""Regressors along a course are those of a simulation, moment by moment."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.course import Course
from cocorosim_ros.world.terms.moment import Moment, clearance
from cocorosim_ros.world.terms.regressors import (
    HEADING,
    REGRESSOR,
    REGRESSOR_COUNT,
    REGRESSORS,
    Extent,
    fill_regressors,
    values_along,
)

POINTS = 40
RATE, PHASE = 0.7, 0.2  # rad/s, rad
LOWER, UPPER = np.array([-1.0, -2.0, -3.0]), np.array([1.5, 2.0, 0.0])


def course(robots: int = 3, own: int = 1) -> Course:
    """Anything, with three robots, partly beyond the walls."""
    random = np.random.default_rng(7)
    around = random.normal(size=(POINTS, robots, 5))
    return Course(
        0.25 * np.arange(POINTS), random.normal(size=(POINTS, 12)), random.normal(size=(POINTS, 4)),
        random.normal(size=(POINTS, 3)), random.normal(size=(POINTS, 3)), np.array([False, False, True]),
        (LOWER, UPPER), around, own,
    )  # fmt: skip


def at(seen: Course, point: int) -> np.ndarray:
    """What the compiled function makes of one moment of the course."""
    row, values = seen.state[point], np.empty(REGRESSOR_COUNT)
    moment = Moment(
        seen.time[point], seen.thrust[point], seen.force[point], np.zeros((3, 4)), seen.is_pump,
        seen.force[point, 2], seen.rate[point, 2], 0.0, 0.0, clearance(row, LOWER, UPPER),
        seen.neighbours[point], seen.own, 0.0, np.zeros((0, 8)),
    )  # fmt: skip
    fill_regressors(row, row[4:8], moment, RATE * seen.time[point] + PHASE, values)
    return values


def test_both_ways_give_the_same() -> None:
    """Every regressor at every moment, up to the rounding of sines and roots."""
    seen = course()
    values = values_along(seen, RATE, PHASE)
    assert list(values) == list(REGRESSOR)
    compiled = np.array([at(seen, point) for point in range(POINTS)])
    for code, regressor in enumerate(REGRESSORS):
        np.testing.assert_allclose(values[regressor.name], compiled[:, code], rtol=1e-12, atol=1e-14)
    np.testing.assert_array_equal(values[HEADING.name], seen.state[:, YAW])


@pytest.mark.parametrize(("robots", "own"), [(0, -1), (1, 0)])
def test_without_neighbours_their_distance_is_infinite(robots: int, own: int) -> None:
    """Both ways."""
    seen = course(robots, own)
    code = [regressor.name for regressor in REGRESSORS].index("neighbour_distance")
    assert np.isposinf(values_along(seen)["neighbour_distance"]).all()
    assert np.isposinf(at(seen, 0)[code])


def test_neighbours_that_stand_still_are_given_once() -> None:
    """One row of neighbours holds for all moments: 5 m away at (3, 4, 0) from the origin."""
    seen = course()._replace(state=np.zeros((POINTS, 8)), neighbours=np.array([[[3.0, 4.0, 0.0]]]), own=-1)
    np.testing.assert_array_equal(values_along(seen)["neighbour_distance"], 5.0)


def test_names_are_told_apart_and_explained() -> None:
    """No name twice; each with a meaning; the effort of thrusters counts each by its own amount."""
    assert len(REGRESSOR) == REGRESSOR_COUNT + 1
    assert all(regressor.meaning for regressor in REGRESSOR.values())
    effort = REGRESSOR["thrust"].effort
    assert effort is not None
    seen = course()
    np.testing.assert_allclose(effort(seen, seen.time), np.abs(seen.force[:, 0]) + np.abs(seen.force[:, 1]))


def test_typical_sizes() -> None:
    """Root mean squares of what is seen, never nothing; walls count where they are known."""
    extent = Extent(np.array([0.3, 0.2, 0.0, 1.0, 0.04, 0.03, 0.0, 0.5]), 60.0, np.array([0.02, 0.01, 0.1, 1e-3]), True)
    size = {regressor.name: regressor.typical(extent) for regressor in REGRESSORS}
    assert (size["x"], size["z"], size["t"], size["r"]) == (0.3, 1e-6, 60.0, 0.5)
    assert size["speed"] == pytest.approx(0.05)
    assert size["sin_t"] == pytest.approx(1.0 / math.sqrt(2.0))
    assert size["thrust"] == pytest.approx(0.01)
    assert size["wall_distance"] == 0.5
    assert REGRESSOR["wall_distance"].typical(extent._replace(enclosed=False)) == 0.0
