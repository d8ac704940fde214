"""Bootstrap intervals: as theory has them, and none where runs are too few."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.study.results.bootstrap import bootstrap_interval


def _mean(values: np.ndarray) -> np.ndarray:
    return values.mean(axis=-1)


def _difference(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first.mean(axis=-1) - second.mean(axis=-1)


def test_of_a_mean() -> None:
    """Of many values it is the mean plus and minus 1.96 standard errors."""
    values = np.random.default_rng(4).normal(3.0, 2.0, 400)
    reach = 1.96 * values.std() / 20
    low, high = bootstrap_interval([values], _mean)
    assert (low, high) == pytest.approx((values.mean() - reach, values.mean() + reach), abs=0.1 * reach)
    assert bootstrap_interval([values], _mean) == (low, high)


def test_samples_are_drawn_independently() -> None:
    """The variances of two equal samples add up: drawn together, their difference would always be 0."""
    values = np.random.default_rng(5).normal(0.0, 1.0, 400)
    low, high = bootstrap_interval([values, values], _difference)
    assert (low, high) == pytest.approx((-1.96 * math.sqrt(2) / 20, 1.96 * math.sqrt(2) / 20), rel=0.15)


def test_five_runs_have_none() -> None:
    """One sample of five is enough to have none; two of six have one."""
    five, six = np.arange(5.0), np.arange(6.0)
    assert all(map(math.isnan, bootstrap_interval([six, five], _difference)))
    assert not any(map(math.isnan, bootstrap_interval([six, six], _difference)))
