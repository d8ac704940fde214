"""Vargha-Delaney A by hand, by ranks and by theory; its intervals hold what they promise."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy import stats

from cocorosim_ros.study.results.effect_size import Effect, effect, vargha_delaney


def test_by_hand() -> None:
    """Of the six pairs of (1, 2, 3) and (2, 4) one and a half are won: a draw at 2 and a win of 3 over 2."""
    assert vargha_delaney(np.array([1.0, 2.0, 3.0]), np.array([2.0, 4.0])) == 1.5 / 6
    assert vargha_delaney(np.array([1.0]), np.array([1.0])) == 0.5
    assert vargha_delaney(np.array([3.0, 3.0]), np.array([1.0, 2.0])) == 1.0
    assert math.isnan(vargha_delaney(np.array([]), np.array([1.0])))


@pytest.mark.parametrize("ties", [0, 1])
def test_by_ranks(ties: int) -> None:
    """(2 R1 - m (m + 1)) / (2 m n) with scipy's mid-ranks, with ties and without; and one minus it the other way."""
    draw = np.random.default_rng(ties)
    for m, n in ((5, 9), (40, 40), (400, 37)):
        first, second = draw.normal(0.3, 1, m).round(3 - 3 * ties), draw.normal(0, 1, n).round(3 - 3 * ties)
        rank_sum = stats.rankdata(np.concatenate([first, second]))[:m].sum()
        assert vargha_delaney(first, second) == pytest.approx((2 * rank_sum - m * (m + 1)) / (2 * m * n), abs=1e-15)
        assert vargha_delaney(second, first) == pytest.approx(1 - vargha_delaney(first, second), abs=1e-15)


@pytest.mark.parametrize(
    ("value", "size"),
    [
        (0.5, "none"), (0.559, "none"), (0.56, "small"), (0.44, "small"), (0.64, "medium"), (0.36, "medium"),
        (0.709, "medium"), (0.71, "large"), (0.29, "large"), (0.2901, "medium"), (1.0, "large"),
        (math.nan, "undefined"),
    ],
)  # fmt: skip
def test_sizes(value: float, size: str) -> None:
    """The paper's thresholds, inclusive on both sides."""
    assert Effect(value, 0, 1).size == size


@pytest.mark.parametrize(("shift", "spread"), [(0.0, 1.0), (1.0, 1.0), (1.0, 3.0), (2.5, 1.0)])
def test_intervals_hold_the_truth_in_95_of_100(shift: float, spread: float) -> None:
    """For normal samples A is Phi(shift / sqrt(1 + spread^2)): 91 to 99 of 100 intervals contain it."""
    draw, truth, held = np.random.default_rng(8), stats.norm.cdf(shift / math.hypot(1, spread)), 0
    for _ in range(600):
        found = effect(draw.normal(shift, 1, 30), draw.normal(0, spread, 40))
        held += found.low <= truth <= found.high
    assert 0.92 <= held / 600 <= 0.985


def test_samples_that_do_not_overlap_have_an_interval_all_the_same() -> None:
    """A is 1, and the interval is that of Newcombe: the a with 1 - a = z sqrt(variance of a)."""
    found = effect(np.arange(10.0) + 100, np.arange(10.0))
    assert found.value == found.high == 1.0
    a = found.low
    variance = a * (1 - a) * (1 + 9 * ((1 - a) / (2 - a) + a / (1 + a))) / 100
    assert (1 - a) == pytest.approx(1.959963984540054 * math.sqrt(variance)) and 0.5 < a < 0.95
    mirrored = effect(np.arange(10.0), np.arange(10.0) + 100)
    assert (mirrored.low, mirrored.high) == (0.0, pytest.approx(1 - a))


def test_undefined_values_are_left_out() -> None:
    """NaN counts nothing; a sample of NaN alone has no A."""
    known, other = np.array([1.0, 2.0, 3.0]), np.array([2.0, 4.0])
    assert effect(np.append(known, np.nan), other) == effect(known, other)
    assert effect(np.array([np.nan]), other).size == "undefined"


def test_equal_samples() -> None:
    """Two samples of one and the same number are the same, within an interval around a half."""
    found = effect(np.ones(20), np.ones(20))
    assert found.value == 0.5 and found.direction == "same" and found.low < 0.5 < found.high
