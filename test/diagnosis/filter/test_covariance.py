"""The flat covariance of the filter beside NumPy's matrices."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.filter.covariance import (
    spread,
    spread_upright,
    transition,
    transition_upright,
    update,
    update_upright,
)
from cocorosim_ros.diagnosis.filter.random_force import fading
from cocorosim_ros.world.terms.blocks import HFX, HGX, HORIZONTAL, VERTICAL

STEP, NOISE = 0.1, 0.3
FADE = fading(STEP, 2.5, 0.4)


def positive(rng: np.random.Generator, size: int) -> Any:
    """A covariance."""
    root = rng.standard_normal((size, size))
    return root @ root.T + np.eye(size)


def second_order(slope: Any, forces: int) -> Any:
    """I + h S + (h S)^2 / 2 of pose and velocity, on which the random forces act by their mean over the step.

    slope (places, places + 2 forces): pose and velocity, forces, gusts.
    """
    places, size = slope.shape
    own = slope[:, :places]
    ahead = np.eye(size)
    ahead[:places, :places] += STEP * own + 0.5 * STEP**2 * own @ own
    act = (STEP * np.eye(places) + 0.5 * STEP**2 * own) @ slope[:, places : places + forces]
    ahead[:places, places : places + forces] = 0.5 * (1.0 + FADE.kept) * act
    ahead[:places, places + forces :] = 0.5 * FADE.fed * act
    ahead[places : places + forces, places : places + forces] = FADE.kept * np.eye(forces)
    ahead[places : places + forces, places + forces :] = FADE.fed * np.eye(forces)
    ahead[places + forces :, places + forces :] = FADE.gust * np.eye(forces)
    return ahead


def slopes(rng: np.random.Generator, places: int, size: int, forces: int) -> Any:
    """On gusts nothing depends directly."""
    slope = rng.standard_normal((places, size))
    slope[:, -forces:] = 0.0
    return slope


def test_the_horizontal_block_spreads() -> None:
    """P becomes T P T^T, with T to second order in the step."""
    rng = np.random.default_rng(1)
    slope, covariance = slopes(rng, HFX, HORIZONTAL, HORIZONTAL - HGX), positive(rng, HORIZONTAL)
    ahead, back, spreading = np.zeros(HORIZONTAL**2), np.zeros(HORIZONTAL**2), covariance.ravel().copy()
    transition(slope.ravel(), STEP, FADE, ahead, back)
    expected = second_order(slope, HORIZONTAL - HGX)
    np.testing.assert_allclose(ahead.reshape(HORIZONTAL, HORIZONTAL), expected, rtol=1e-13, atol=1e-13)
    spread(spreading, ahead, back)
    np.testing.assert_allclose(
        spreading.reshape(HORIZONTAL, HORIZONTAL), expected @ covariance @ expected.T, rtol=1e-12
    )
    whole = spreading.reshape(HORIZONTAL, HORIZONTAL)
    np.testing.assert_array_equal(whole, whole.T)


def test_the_vertical_block_spreads() -> None:
    """The same of height, heave and its force."""
    rng = np.random.default_rng(2)
    slope, covariance = slopes(rng, VERTICAL - 2, VERTICAL, 1), positive(rng, VERTICAL)
    ahead, spreading = np.zeros(VERTICAL * VERTICAL), covariance.ravel().copy()
    transition_upright(slope.ravel(), STEP, FADE, ahead)
    expected = second_order(slope, 1)
    np.testing.assert_allclose(ahead.reshape(VERTICAL, VERTICAL), expected, rtol=1e-13, atol=1e-13)
    spread_upright(spreading, ahead)
    np.testing.assert_allclose(spreading.reshape(VERTICAL, VERTICAL), expected @ covariance @ expected.T, rtol=1e-12)


@pytest.mark.parametrize("horizontal", [True, False])
@pytest.mark.parametrize("believed", [True, False])
def test_a_reading_shrinks_it(horizontal: bool, believed: bool) -> None:
    """Kalman's gain and covariance; a reading that is not believed may pull, but makes nothing surer."""
    rng = np.random.default_rng(3)
    size = HORIZONTAL if horizontal else VERTICAL
    covariance, seen = positive(rng, size), rng.standard_normal(size)
    variance = seen @ covariance @ seen + NOISE
    expected = covariance @ seen / variance
    shrinking, gain = covariance.ravel().copy(), np.zeros(size)
    gate = (35.9 if believed else 36.1) * variance
    found = (update if horizontal else update_upright)(shrinking, seen, NOISE, gain, gate)
    assert found == pytest.approx(variance)
    np.testing.assert_allclose(gain, expected, rtol=1e-12)
    left = shrinking.reshape(size, size)
    shrunk = covariance - np.outer(expected, covariance @ seen) if believed else covariance
    np.testing.assert_allclose(left, shrunk, rtol=1e-10, atol=1e-12)
