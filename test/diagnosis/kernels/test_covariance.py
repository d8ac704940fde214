"""The flat covariance of the filter beside NumPy's matrices."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.kernels.covariance import (
    spread,
    spread_upright,
    transition,
    transition_upright,
    update,
    update_upright,
)
from cocorosim_ros.diagnosis.kernels.layout import HFX, HORIZONTAL, PADDED, VERTICAL

STEP, DECAY, NOISE = 0.1, 0.96, 0.3


def flat(matrix: Any) -> Any:
    """With rows of PADDED columns."""
    return np.pad(matrix, ((0, 0), (0, PADDED - matrix.shape[1]))).ravel()


def square(flattened: Any) -> Any:
    """(HORIZONTAL, HORIZONTAL) without the padding."""
    return flattened.reshape(HORIZONTAL, PADDED)[:, :HORIZONTAL]


def positive(rng: np.random.Generator, size: int) -> Any:
    """A covariance."""
    root = rng.standard_normal((size, size))
    return root @ root.T + np.eye(size)


def second_order(slope: Any, forces: int) -> Any:
    """I + h S + (h S)^2 / 2 with random forces that decay by themselves."""
    size = slope.shape[1]
    whole = np.vstack([slope, np.zeros((forces, size))])
    ahead = np.eye(size) + STEP * whole + 0.5 * STEP**2 * whole @ whole
    ahead[-forces:] = DECAY * np.eye(size)[-forces:]
    return ahead


def test_the_horizontal_block_spreads() -> None:
    """P becomes T P T^T, with T to second order in the step."""
    rng = np.random.default_rng(1)
    slope, covariance = rng.standard_normal((HFX, HORIZONTAL)), positive(rng, HORIZONTAL)
    ahead, back, spreading = np.zeros(HORIZONTAL * PADDED), np.zeros(HORIZONTAL * PADDED), flat(covariance)
    transition(flat(slope), STEP, DECAY, ahead, back)
    expected = second_order(slope, HORIZONTAL - HFX)
    np.testing.assert_allclose(square(ahead), expected, rtol=1e-13, atol=1e-13)
    spread(spreading, ahead, back)
    np.testing.assert_allclose(square(spreading), expected @ covariance @ expected.T, rtol=1e-12)
    np.testing.assert_array_equal(square(spreading), square(spreading).T)


def test_the_vertical_block_spreads() -> None:
    """The same of height, heave and its force."""
    rng = np.random.default_rng(2)
    slope, covariance = rng.standard_normal((VERTICAL - 1, VERTICAL)), positive(rng, VERTICAL)
    ahead, spreading = np.zeros(VERTICAL * VERTICAL), covariance.ravel().copy()
    transition_upright(slope.ravel(), STEP, DECAY, ahead)
    expected = second_order(slope, 1)
    np.testing.assert_allclose(ahead.reshape(VERTICAL, VERTICAL), expected, rtol=1e-13, atol=1e-13)
    spread_upright(spreading, ahead)
    np.testing.assert_allclose(spreading.reshape(VERTICAL, VERTICAL), expected @ covariance @ expected.T, rtol=1e-12)


@pytest.mark.parametrize("horizontal", [True, False])
@pytest.mark.parametrize("believed", [True, False])
def test_a_reading_shrinks_it(horizontal: bool, believed: bool) -> None:
    """Kalman's gain and covariance; a reading that is not believed changes nothing."""
    rng = np.random.default_rng(3)
    size = HORIZONTAL if horizontal else VERTICAL
    covariance, seen = positive(rng, size), rng.standard_normal(size)
    variance = seen @ covariance @ seen + NOISE
    expected = covariance @ seen / variance if believed else np.zeros(size)
    shrinking, gain = flat(covariance) if horizontal else covariance.ravel().copy(), np.zeros(PADDED)
    padded = np.pad(seen, (0, PADDED - size))
    gate = (35.9 if believed else 36.1) * variance
    found = (update if horizontal else update_upright)(shrinking, padded, NOISE, gain, gate)
    assert found == pytest.approx(variance)
    np.testing.assert_allclose(gain[:size], expected, rtol=1e-12)
    left = square(shrinking) if horizontal else shrinking.reshape(VERTICAL, VERTICAL)
    np.testing.assert_allclose(left, covariance - np.outer(expected, covariance @ seen), rtol=1e-10, atol=1e-12)
