"""The compiled median against numpy."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from cocorosim_ros.study.metrics.median import median_of_first


@settings(deadline=None, max_examples=300)
@given(st.lists(st.sampled_from([-1.5, 0.0, 1.0, 2.0, 2.0, 7.25]) | st.floats(-1e6, 1e6), min_size=1, max_size=80))
def test_median_is_numpys(numbers: list[float]) -> None:
    """Any numbers, many of them equal, in any order have numpy's median; what stands behind them is not
    looked at.
    """
    values = np.array([*numbers, -1e9])
    assert median_of_first(values, len(numbers)) == np.median(numbers)


def test_many_equal_values_take_no_quadratic_time() -> None:
    """A million equal values are done at once: with quadratic time this test would take minutes."""
    assert median_of_first(np.full(1_000_000, 0.25), 1_000_000) == 0.25


def test_median_of_nothing_is_not_a_number() -> None:
    """No values, no median."""
    assert np.isnan(median_of_first(np.ones(1), 0))
