"""The random force of the water beside matrix exponentials and Lyapunov's equation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import expm, solve_continuous_lyapunov

from cocorosim_ros.diagnosis.filter.random_force import fading


@pytest.mark.parametrize(
    ("correlation", "smoothness", "step"), [(2.5, 1.0, 0.1), (2.5, 0.99999, 0.1), (2.5, 0.4, 0.1), (5.0, 0.04, 0.05)]
)
def test_a_step_is_exact(correlation: float, smoothness: float, step: float) -> None:
    """Force and gust fade by exp(A h), and what comes in keeps their covariance that of the stationary process."""
    middle = 2.0 / (smoothness * correlation)
    half = middle * math.sqrt(1.0 - smoothness)
    slow, fast = middle - half, middle + half
    assert 1.0 / slow + 1.0 / fast == pytest.approx(correlation)
    rates = np.array([[-slow, math.sqrt(slow * (slow + fast))], [0.0, -fast]])
    stationary = solve_continuous_lyapunov(rates, np.diag([0.0, -2.0 * fast]))
    np.testing.assert_allclose(np.diag(stationary), 1.0, rtol=1e-10)
    ahead = expm(rates * step)
    new = stationary - ahead @ stationary @ ahead.T
    found = fading(step, correlation, smoothness)
    expected = (ahead[0, 0], ahead[0, 1], ahead[1, 1], stationary[0, 1], new[0, 0], new[0, 1], new[1, 1])
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-13)


def test_a_smooth_one_is_matern() -> None:
    """At smoothness 1 the autocorrelation over a step h is (1 + k h) exp(-k h), k = 2 / T; Rasmussen, eq. 4.17."""
    found = fading(0.7, 2.5, 1.0)
    k = 2.0 / 2.5
    assert found.kept + found.fed * found.common == pytest.approx((1.0 + 0.7 * k) * math.exp(-0.7 * k))


def test_a_rough_one_forgets_like_ornstein_and_uhlenbeck() -> None:
    """At smoothness 0.001 the autocorrelation is exp(-h / T) to a thousandth."""
    found = fading(0.7, 2.5, 0.001)
    assert found.kept + found.fed * found.common == pytest.approx(math.exp(-0.7 / 2.5), rel=1e-3)
