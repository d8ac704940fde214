"""The procedure of Read et al. 2011 gives what theory says under chance alone."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pyarrow.compute as pc
import pytest
from scipy import integrate, stats

from cocorosim_ros.study.results.sample_size import (
    Consistency,
    baseline_consistency,
    consistency_by_chance,
    consistency_of,
    consistency_scores,
)


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
    """All scores are a half, however few runs there are."""
    found = consistency_of(np.full((1, 2), 2.0), 3, np.random.default_rng(0))
    assert found.median_of_largest == 0.5 and found.enough == 1.0 and found.each == (0.5,)


def test_responses_of_one_run_stay_together() -> None:
    """Twice the same response is as good as once; six that are independent reach further than any of them."""
    draw, repetitions = np.random.default_rng(2), 200
    six = draw.random((6, 400))
    one = consistency_of(six[:1], 400, np.random.default_rng(3), repetitions)
    twice = consistency_of(six[[0, 0]], 400, np.random.default_rng(3), repetitions)
    assert twice == replace(one, each=one.each * 2) and one.median_of_largest == one.each[0]
    all_six = consistency_of(six, 400, np.random.default_rng(4), repetitions)
    expected = chance_by_theory(400) ** 6
    assert all_six.enough == pytest.approx(expected, abs=4 * math.sqrt(expected * (1 - expected) / repetitions))
    assert max(all_six.each) < all_six.median_of_largest < 0.56


def test_ties_make_chance_smaller() -> None:
    """A response that is 0 in nine of ten runs: all those pairs count a half."""
    rare = (np.arange(400) % 10 == 0).astype(float)
    ties, none = (consistency_of(values[None], 100, np.random.default_rng(5)) for values in (rare, np.arange(400.0)))
    # The variance of A is by 1 - 0.9^3 - 0.1^3 = 0.27 that of values without ties.
    spread = (ties.median_of_largest - 0.5) / (none.median_of_largest - 0.5)
    assert spread == pytest.approx(math.sqrt(0.27), rel=0.1)


def test_sizes_that_the_runs_of_the_baseline_allow(made_up: Callable[..., Any]) -> None:
    """Of 40 runs, sets of 1, 5 and 10; one that has no polarisation is left out, so that of ten there are nine."""
    results = made_up("boids", ("Van", "BLT"), {("BLT", "lost"): 1.0})
    found = baseline_consistency(results, "paper", ("polarisation", "lost"))
    assert [one.runs for one in found] == [1, 5, 10] and all(len(one.each) == 2 for one in found)
    assert found == baseline_consistency(results, "paper", ("polarisation", "lost"))
    ten = results.table.filter(pc.less(results.table["replicate"], 10))
    column = ten.schema.get_field_index("polarisation")
    holed = ten.set_column(column, "polarisation", pc.if_else(pc.equal(ten["replicate"], 3), math.nan, ten["lost"]))
    assert [one.runs for one in baseline_consistency(replace(results, table=holed), "paper", ("polarisation",))] == [
        1,
        5,
    ]


def test_the_share_has_an_interval() -> None:
    """Wilson's interval of 80 in 100 is 0.711 to 0.867."""
    low, high = Consistency(400, (0.54,), 0.55, 0.8, 100).enough_interval
    assert (low, high) == pytest.approx((0.7112, 0.8666), abs=1e-4)
