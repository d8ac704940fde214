"""The variance between recordings, by hand and beside what made the values."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.between_recordings import variance_between


def test_of_equal_weights_it_is_the_sample_variance_less_that_of_each() -> None:
    """1, 2, 3 and 6 have the sample variance 14/3; each is known to a variance of 0.5."""
    assert variance_between(np.array([1.0, 2.0, 3.0, 6.0]), np.full(4, 2.0)) == pytest.approx(14.0 / 3.0 - 0.5)


def test_values_that_differ_by_their_noise_alone_have_none() -> None:
    """Never less than nothing."""
    assert variance_between(np.array([1.0, 1.1, 0.9]), np.ones(3)) == 0.0


def test_it_is_that_which_made_the_values() -> None:
    """Of 4000 biases with a variance of 0.09, each told with another noise."""
    rng = np.random.default_rng(20261129)
    weight = rng.uniform(2.0, 200.0, 4000)
    value = rng.normal(0.4, 0.3, 4000) + rng.standard_normal(4000) / np.sqrt(weight)
    assert variance_between(value, weight) == pytest.approx(0.09, rel=0.1)
