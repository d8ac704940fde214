"""Corruption of readings: known distributions, order, and nothing where nothing is asked for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest
from scipy import stats

from cocorosim_ros.scenario.parts.corruption import Corruption
from cocorosim_ros.world.seeding.corruption_at_work import Swarms
from cocorosim_ros.world.sensors.corruption import channel_values, corrupted_channels
from cocorosim_ros.world.sensors.readings import Readings, blank_readings

NAMES = ("lily_01", "lily_02", "lily_03")
TICKS = 2000
SIGNIFICANT = 1e-4  # the draws are fixed by the seed, so a test passes always or never


def spoiled(corruptions: Sequence[Corruption], values: Any, ticks: int = TICKS, runs: range = range(1)) -> Any:
    """(ticks, runs, robots, width) what the first corruption's channel shows when `values` are measured always."""
    chain = corrupted_channels(corruptions, Swarms(7, NAMES, runs))
    shown = []
    for tick in range(ticks):
        readings = blank_readings(len(runs), len(NAMES), 5)
        measured = values[tick] if isinstance(values, np.ndarray) else values
        channel_values(readings, corruptions[0].channel)[...] = measured
        for part in chain:
            part.apply(tick, readings)
        shown.append(channel_values(readings, corruptions[0].channel).copy())
    return np.array(shown)


def test_noise_is_gaussian_with_its_standard_deviation() -> None:
    """6000 pressures: mean 0, 20 Pa, by Kolmogorov and Smirnov; no two robots alike."""
    shown = spoiled([Corruption("pressure", "noise", {"sd": 20.0})], 101325.0)[..., 0] - 101325.0
    assert stats.kstest(shown.ravel() / 20.0, "norm").pvalue > SIGNIFICANT
    assert abs(np.corrcoef(shown[:, 0, 0], shown[:, 0, 1])[0, 1]) < 4.0 / np.sqrt(TICKS)
    assert abs(np.corrcoef(shown[1:, 0, 0], shown[:-1, 0, 0])[0, 1]) < 4.0 / np.sqrt(TICKS)


def test_range_factor_is_uniform_and_short() -> None:
    """The released model's U(0.8, 1.0) of 0.4 m: evenly from 0.32 to 0.4 m; who sees nobody sees nobody."""
    shown = spoiled([Corruption("neighbour_range", "range_factor", {"least": 0.8, "most": 1.0})], 0.4)
    assert stats.kstest(shown.ravel(), stats.uniform(0.32, 0.08).cdf).pvalue > SIGNIFICANT
    assert np.isinf(spoiled([Corruption("neighbour_range", "range_factor", {"least": 0, "most": 0})], np.inf, 3)).all()


@pytest.mark.parametrize(("channel", "missing"), [("neighbour_range", np.isposinf), ("compass", np.isnan)])
def test_dropout_has_its_probability(channel: str, missing: Any) -> None:
    """A fifth of the readings is missing, as +inf for ranges and NaN otherwise (REP 117); binomial test."""
    shown = spoiled([Corruption(channel, "dropout", {"probability": 0.2})], 0.3)
    lost = missing(shown)
    assert stats.binomtest(int(lost.sum()), lost.size, 0.2).pvalue > SIGNIFICANT
    assert (shown[~lost] == 0.3).all()


def test_an_instrument_drops_out_as_a_whole() -> None:
    """All three axes of the gyro are missing together, or none."""
    lost = np.isnan(spoiled([Corruption("gyro", "dropout", {"probability": 0.5})], 0.1))
    assert (lost.all(axis=-1) == lost.any(axis=-1)).all()
    assert 0 < lost.mean() < 1


def test_bias_quantisation_and_wrapping() -> None:
    """pi - 0.1 with a bias of 0.25 is -pi + 0.15; rounded to 0.1 first it is 3.0 + 0.25."""
    bias, steps = Corruption("compass", "bias", {"offset": 0.25}), Corruption("compass", "quantisation", {"step": 0.1})
    assert spoiled([bias], np.pi - 0.1, 1)[0, 0, 0, 0] == pytest.approx(-np.pi + 0.15)
    assert spoiled([steps, bias], np.pi - 0.1, 1)[0, 0, 0, 0] == pytest.approx(3.25 - 2 * np.pi)
    assert spoiled([bias, steps], 0.12, 1)[0, 0, 0, 0] == pytest.approx(0.4)  # 0.37, rounded last


def test_delay_shows_what_was() -> None:
    """Two ticks late: missing, missing, then the first."""
    values = np.arange(6.0)[:, None, None, None]
    shown = spoiled([Corruption("pressure", "delay", {"ticks": 2.0})], values, 6)[:, 0, 0, 0]
    np.testing.assert_array_equal(shown, [np.nan, np.nan, 0, 1, 2, 3])


def test_ranges_do_not_fall_below_zero() -> None:
    """With more noise than range nothing is nearer than 0 m."""
    shown = spoiled([Corruption("obstacle_range", "noise", {"sd": 1.0})], 0.1)
    assert shown.min() == 0.0
    assert shown.max() > 1.0


def test_only_the_chosen_robots_are_concerned() -> None:
    """lily_02 alone is biased."""
    shown = spoiled([Corruption("pressure", "bias", {"offset": 5.0}, ("lily_02",))], 1.0, 1)
    assert shown[0, 0, :, 0].tolist() == [1.0, 6.0, 1.0]


def test_what_is_not_listed_is_not_touched() -> None:
    """Noise on the compass leaves every other instrument bit for bit."""
    draw = np.random.default_rng(1)
    readings = Readings(*(draw.normal(size=part.shape) for part in blank_readings(1, 3, 5)))
    before = [part.copy() for part in readings]
    corrupted_channels([Corruption("compass", "noise", {"sd": 1.0})], Swarms(7, NAMES, range(1)))[0].apply(0, readings)
    changed = [not np.array_equal(part, old) for part, old in zip(readings, before, strict=True)]
    assert [name for name, is_changed in zip(Readings._fields, changed, strict=True) if is_changed] == ["compass"]


def test_two_of_a_kind_draw_their_own_numbers() -> None:
    """Noise twice has the standard deviation of the root of two, not of two."""
    noise = Corruption("pressure", "noise", {"sd": 1.0})
    assert spoiled([noise, noise], 0.0).std() == pytest.approx(np.sqrt(2.0), rel=0.05)


def test_a_run_of_a_batch_is_the_run_alone() -> None:
    """Run 5 among eight has the numbers of run 5 by itself; other runs have others."""
    noise = [Corruption("pressure", "noise", {"sd": 1.0}), Corruption("pressure", "dropout", {"probability": 0.1})]
    batch, alone = spoiled(noise, 0.0, 300, range(8)), spoiled(noise, 0.0, 300, range(5, 6))
    np.testing.assert_array_equal(batch[:, 5:6], alone)
    assert not np.array_equal(batch[:, 4:5], alone, equal_nan=True)
