"""Distances from the figure, by hand, and that its data are those of the claims."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.study.claims.claims import HIGHER, LOWER, NOT_LARGE, Claim
from cocorosim_ros.study.figure4.published import Box, Number, published_figure


@pytest.mark.parametrize(
    ("paper", "a", "distance"),
    [
        (HIGHER, 0.71, 0.0),
        (HIGHER, 0.5, 1.0),
        (HIGHER, 0.08, 3.0),
        (LOWER, 0.29, 0.0),
        (LOWER, 0.5, 1.0),
        (NOT_LARGE, 0.6, 0.0),
        (NOT_LARGE, 0.29, 0.0),
        (NOT_LARGE, 0.92, 1.0),
        (NOT_LARGE, 0.08, 1.0),
        (HIGHER, math.nan, 3.0),
    ],
)
def test_distance_of_a_box(paper: str, a: float, distance: float) -> None:
    """Zero on the claimed side, one for each 0.21 beyond the threshold."""
    box = Box(Claim("S1", "boids", "BLT", "Van", "polarisation", paper))
    assert box.distance(a) == pytest.approx(distance)


def test_distance_of_a_number() -> None:
    """Factors of two, whichever way, at most three of them; three without a number."""
    number = Number("BLT", "shoals", 1.0, 0.01)
    assert [number.distance(value) for value in (1.0, 2.0, 0.25, 100.0, 0.0, math.nan)] == [0, 1, 2, 3, 3, 3]


def test_responses_are_a_and_the_median() -> None:
    """Of 1, 2, 3 against 2, 3, 4 one of 9 pairs is greater and two are equal, A is 2/9. The median of 2, 3, 4 is 3."""
    runs = {"BLT": np.array([1.0, 2.0, 3.0, np.nan]), "Van": np.array([2.0, 3.0, 4.0])}
    box = Box(Claim("S1", "boids", "BLT", "Van", "polarisation", HIGHER))
    assert box.response(lambda group, column: runs[group], "any") == pytest.approx((1 + 2 / 2) / 9)
    assert Number("Van", "shoals", 1.0, 0.01).response(lambda group, column: runs[group], "any") == 3.0


def test_the_figure_is_the_claims_and_the_known_numbers() -> None:
    """18 boxes and 4 numbers of boids, 12 boxes of turbulence; angular momentum in the reading that was compared."""
    boids, turbulence = published_figure("boids"), published_figure("turbulence")
    assert [sum(isinstance(each, Box) for each in half.shown) for half in (boids, turbulence)] == [18, 12]
    numbers = [each for each in boids.shown if isinstance(each, Number)]
    assert len(numbers) == 4
    assert not any(isinstance(each, Number) for each in turbulence.shown)
    assert all(0.0 < each.digit <= 0.01 * each.value for each in numbers)
    assert all("raw" in column and "median_centre" in column for column in boids.columns["angular_momentum"])
    assert len(turbulence.columns["angular_momentum"]) == 32
