"""Moving, turning, mirroring and renumbering the swarm changes nothing else.

The robots do not look back here: who sees one robot straight behind and hears nobody may turn either way, and
rounding decides which.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

TICKS = 40
# Rounding differs, and a shoal multiplies differences; within 20 s by less than a hundred thousand.
TOLERANCE = 1e-9
Make = Callable[..., Any]


@pytest.fixture(scope="module")
def shoal_of(make_simulation: Make, lily: SimpleNamespace) -> Make:
    """Function of a start (1, robots, 4) and the alignment weight: states (robots, columns) after 20 s."""

    def swim(start: Any, alignment: float = 10.0) -> Any:
        settings = np.array(lily.boids)
        settings[[2, 5]] = alignment, 0.0
        simulation = make_simulation(start, "boids_blt", settings)
        for _ in range(TICKS):
            simulation.sense()
            simulation.decide()
            simulation.advance()
        return simulation.state[0]

    return swim


def test_moving_the_swarm_moves_it(shoal_of: Make, crowd: Make) -> None:
    """Twelve metres east and five north: the same shoal there."""
    start = crowd(1, 11)
    shift = np.array([12.0, -5.0, 0.0, 0.0])
    moved, plain = shoal_of(start + shift), shoal_of(start)
    np.testing.assert_allclose(moved[:, :4] - shift, plain[:, :4], rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(moved[:, 4:], plain[:, 4:], rtol=0, atol=TOLERANCE)


@pytest.mark.parametrize(("angle", "alignment"), [(0.5 * math.pi, 10.0), (1.0, 0.0)])
def test_turning_the_swarm_turns_it(shoal_of: Make, crowd: Make, angle: float, alignment: float) -> None:
    """Turned about the vertical: the same shoal, turned.

    By a quarter-turn with all rules, by any angle without alignment: a coordinate-wise median knows the axes.
    """
    start, cosine, sine = crowd(1, 11), math.cos(angle), math.sin(angle)
    matrix = np.array([[cosine, -sine], [sine, cosine]])
    turned = start.copy()
    turned[..., :2] = start[..., :2] @ matrix.T
    turned[..., 3] += angle
    expected = shoal_of(start, alignment)
    expected[:, :2] = expected[:, :2] @ matrix.T
    expected[:, 3] += angle
    np.testing.assert_allclose(shoal_of(turned, alignment), expected, rtol=0, atol=TOLERANCE)


def test_mirroring_the_swarm_mirrors_it(shoal_of: Make, crowd: Make) -> None:
    """Left and right exchanged: the same shoal in the mirror, with left and right thruster exchanged."""
    start = crowd(1, 11)
    expected = shoal_of(start)
    expected[:, [1, 3, 5, 7]] *= -1.0
    expected[:, [8, 9, 11, 12]] = expected[:, [9, 8, 12, 11]]
    np.testing.assert_allclose(shoal_of(start * [1.0, -1.0, 1.0, -1.0]), expected, rtol=0, atol=TOLERANCE)


def test_renumbering_the_swarm_renumbers_it(shoal_of: Make, crowd: Make) -> None:
    """Who is called what makes no difference, to the last bit."""
    start, order = crowd(1, 11), np.random.default_rng(0).permutation(11)
    assert np.array_equal(shoal_of(start[:, order]), shoal_of(start)[order])
