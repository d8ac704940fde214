"""The procedure of Read et al. 2011 gives what theory says under chance alone."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import integrate, stats

from cocorosim_ros.analysis.sample_size import consistency_by_chance, consistency_of, consistency_scores


def chance_by_theory(runs: int) -> float:
    """Probability that 19 scores stay below 0.56: for many runs they are normal, each pair correlated by a half.

    Their variance is that of Mann and Whitney's U, (2 n + 1) / (12 n^2); all share the first set.
    """
    reach = math.sqrt(2) * 0.06 / math.sqrt((2 * runs + 1) / (12 * runs**2))

    def of(first: float) -> float:
        inside = stats.norm.cdf(reach - first) - stats.norm.cdf(-reach - first)
        return float(stats.norm.pdf(first) * inside**19)

    return float(integrate.quad(of, -10, 10)[0])


@pytest.mark.parametrize("runs", [100, 200, 300, 400])
def test_chance_of_staying_below_a_small_effect(runs: int) -> None:
    """The share of 500 repetitions is that of theory, within four standard errors."""
    found, expected = consistency_by_chance(runs, 500, np.random.default_rng(runs)), chance_by_theory(runs)
    assert found.enough == pytest.approx(expected, abs=4 * math.sqrt(expected * (1 - expected) / 500))


def test_400_runs_are_enough() -> None:
    """The paper's number: the largest of 19 scores has the median 0.537 and stays below 0.56 in 96 of 100 cases."""
    found = consistency_by_chance(400, 500, np.random.default_rng(1))
    assert found.median_of_largest == pytest.approx(0.537, abs=0.003)
    assert found.enough == pytest.approx(0.96, abs=0.03) and chance_by_theory(400) == pytest.approx(0.96, abs=0.01)


def test_scores_are_folded() -> None:
    """Lower is as different as higher: 1 - A where A is below a half."""
    sets = np.array([[1.0, 2.0], [0.0, 0.5], [3.0, 4.0], [1.0, 2.0]])
    assert consistency_scores(sets).tolist() == [1.0, 1.0, 0.5]


def test_a_response_that_never_varies_needs_no_runs() -> None:
    """All scores are a half; undefined values are left out."""
    found = consistency_of(np.array([2.0, 2.0, np.nan]), 3, np.random.default_rng(0))
    assert found.median_of_largest == 0.5 and found.enough == 1.0
