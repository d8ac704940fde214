"""Lines through numbers with intervals, against closed forms and scipy's own regression."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.stats import linregress
from scipy.stats import t as student

from cocorosim_ros.diagnosis.fleet.regression import fitted_line

RNG = np.random.default_rng(20261123)


def design(places: np.ndarray) -> np.ndarray:
    """Value at zero, and slope."""
    return np.column_stack([np.ones_like(places), places])


def test_equal_intervals_with_scatter_are_ordinary_regression() -> None:
    """Where all intervals are equal and the scatter is larger, slope and interval are those of least squares."""
    places = np.arange(9.0)
    value = 3.0 - 0.5 * places + RNG.standard_normal(9)
    line, plain = fitted_line(design(places), value, np.full(9, 0.1)), linregress(places, value)
    assert line is not None
    slope = line.estimate(1, "1")
    half = student.ppf(0.975, 7) * plain.stderr
    assert (slope.value, slope.low, slope.high) == pytest.approx(
        (plain.slope, plain.slope - half, plain.slope + half), rel=1e-9
    )
    assert line.chance(1) == pytest.approx(plain.pvalue, rel=1e-9)
    left = value - plain.intercept - plain.slope * places
    assert line.scatter**2 == pytest.approx(np.sum(left**2) / 7 - 0.01, rel=1e-9)


def test_numbers_that_agree_keep_their_intervals() -> None:
    """Without scatter beyond the intervals the mean is the weighted one, no surer than the intervals make it."""
    value, spread = np.array([1.0, 1.01, 0.99, 1.0]), np.array([0.1, 0.2, 0.1, 0.4])
    line = fitted_line(np.ones((4, 1)), value, spread)
    assert line is not None
    weight = 1.0 / spread**2
    mean = line.estimate(0, "m")
    assert line.scatter == 0.0
    assert mean.value == pytest.approx(np.sum(weight * value) / weight.sum(), rel=1e-12)
    assert mean.high - mean.value == pytest.approx(student.ppf(0.975, 3) / math.sqrt(weight.sum()), rel=1e-12)


def test_scatter_makes_weights_equal_and_the_interval_wide() -> None:
    """One very sure number does not decide what many others contradict."""
    value = np.array([0.0, 1.0, 1.1, 0.9, 1.05])
    sure = fitted_line(np.ones((5, 1)), value, np.array([0.001, 0.02, 0.02, 0.02, 0.02]))
    assert sure is not None
    mean = sure.estimate(0, "1")
    assert mean.value == pytest.approx(value.mean(), rel=0.01) and mean.low < 0.5 and mean.high > 1.0


@pytest.mark.parametrize("places", [[1.0, 1.0, 1.0, 1.0], [1.0, 2.0]])
def test_what_cannot_be_told(places: list[float]) -> None:
    """One moment has no slope, and two points leave nothing to judge the line by."""
    assert fitted_line(design(np.array(places)), np.array(places), np.ones(len(places))) is None


def test_numbers_that_are_all_the_same() -> None:
    """A perfect line is fitted without dividing by zero."""
    line = fitted_line(design(np.arange(4.0)), np.full(4, 2.0), np.full(4, 1e-9))
    assert line is not None and line.scatter == 0.0 and line.chance(1) == pytest.approx(1.0)
