"""The noise of single readings comes out right over the sensors' range, whatever the motion does."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.noise import hides_motion, noise_of

WITHIN = 0.15
Motion = Callable[[np.ndarray], np.ndarray]


def swimming(time: np.ndarray) -> np.ndarray:
    """Metres: coasts and starts with 0.02 m/s^2, Lily's full thrust."""
    acceleration = 0.0227 * np.sign(np.sin(0.9 * time) + 0.5 * np.sin(2.3 * time))
    velocity = np.cumsum(acceleration - acceleration.mean()) * np.gradient(time)
    return np.cumsum((velocity - velocity.mean()) * np.gradient(time))


def turning(time: np.ndarray) -> np.ndarray:
    """Radians: up to 1.5 rad/s, with 0.6 rad/s^2."""
    return np.cumsum(1.5 * np.sin(0.4 * time)) * np.gradient(time)


def spinning(time: np.ndarray) -> np.ndarray:
    """Radians per second: steps of the torque every few seconds."""
    torque = np.sign(np.sin(0.7 * time))
    rate = np.zeros(time.size)
    for k in range(1, time.size):
        step = time[k] - time[k - 1]
        rate[k] = rate[k - 1] + step * (0.6 * torque[k] - 0.3 * abs(rate[k - 1]) * rate[k - 1])
    return rate


def diving(time: np.ndarray) -> np.ndarray:
    """Pascals: up and down between 0.3 and 1.5 m at some cm/s."""
    return 101325.0 + 9810.0 * (0.9 + 0.6 * np.sin(0.06 * time))


CASES = [
    (rate, sigma, motion)
    for motion, settings in {
        swimming: [(10.0, sigma) for sigma in (0.001, 0.002, 0.004)],
        turning: [(rate, np.radians(sigma)) for rate in (5.0, 10.0) for sigma in (1.0, 3.0)],
        diving: [(rate, sigma) for rate in (2.0, 5.0, 10.0) for sigma in (5.0, 20.0)],
        spinning: [(rate, sigma) for rate in (10.0, 50.0) for sigma in (0.002, 0.01)],
    }.items()
    for rate, sigma in settings
]


@pytest.mark.parametrize(("rate", "sigma", "motion"), CASES)
def test_known_noise_under_motion(rate: float, sigma: float, motion: Motion) -> None:
    """Camera, compass, pressure, gyroscope: within 15 %, at stamps that jitter, with readings missing."""
    rng = np.random.default_rng(5)
    fine = np.arange(0.0, 300.0, 0.01)
    time = np.sort(np.arange(0.0, 299.0, 1.0 / rate) + 0.03 / rate * rng.standard_normal(int(299 * rate)))
    time = time[(time >= 0.0) & (rng.random(time.size) > 0.03)]
    value = np.interp(time, fine, motion(fine)) + sigma * rng.standard_normal(time.size)
    assert noise_of(time, value) == pytest.approx(sigma, rel=WITHIN)


def test_motion_alone_is_little_noise() -> None:
    """Without noise, what is left of the motion is far below any camera's noise."""
    time = np.arange(0.0, 300.0, 0.1)
    fine = np.arange(0.0, 300.0, 0.01)
    assert noise_of(time, np.interp(time, fine, swimming(fine))) < 0.0002


def test_slow_readings_take_the_quiet_stretches() -> None:
    """Where motion shows between slow readings, the estimate comes from the time when the robot rests."""
    rng = np.random.default_rng(6)
    time = np.arange(0.0, 600.0, 1.0)
    busy = (time % 120.0) < 60.0
    value = np.where(busy, 3.0 * np.sin(2.4 * time), 0.0) + 0.1 * rng.standard_normal(time.size)
    assert noise_of(time, value) == pytest.approx(0.1, rel=0.35)


def test_spikes_and_jumps_do_not_count() -> None:
    """One reading in a hundred is off by a hundred times the noise, and the track jumps once."""
    rng = np.random.default_rng(7)
    time = np.arange(0.0, 200.0, 0.1)
    value = 0.002 * rng.standard_normal(time.size) + np.where(time > 90.0, 1.0, 0.0)
    value[rng.integers(0, time.size, 20)] += 0.2
    assert noise_of(time, value) == pytest.approx(0.002, rel=WITHIN)


def test_readings_not_given_do_not_count() -> None:
    """NaN is no reading."""
    rng = np.random.default_rng(8)
    time = np.arange(0.0, 200.0, 0.1)
    value = 0.002 * rng.standard_normal(time.size)
    value[::5] = np.nan
    assert noise_of(time, value) == pytest.approx(0.002, rel=WITHIN)


def test_a_gap_is_not_bridged() -> None:
    """Windows across a gap, over which the robot went elsewhere, do not count."""
    rng = np.random.default_rng(9)
    time = np.concatenate([10.0 * k + np.arange(0.0, 0.8, 0.1) for k in range(40)])
    value = 5.0 * np.sin(0.2 * time) + 0.002 * rng.standard_normal(time.size)
    assert noise_of(time, value) == pytest.approx(0.002, rel=0.25)


def test_steps_of_a_reading() -> None:
    """In steps of 10 Pa the noise is the sensor's and the rounding's: sqrt(sigma^2 + q^2/12); at rest q/sqrt(12)."""
    rng = np.random.default_rng(10)
    time = np.arange(0.0, 300.0, 0.1)
    value = 10.0 * np.rint((diving(time) + 8.0 * rng.standard_normal(time.size)) / 10.0)
    assert noise_of(time, value) == pytest.approx(np.hypot(8.0, 10.0 / np.sqrt(12.0)), rel=WITHIN)
    still = np.where(time < 150.0, 101330.0, 101340.0)
    assert noise_of(time, still) == pytest.approx(10.0 / np.sqrt(12.0), rel=1e-6)


def test_repeated_readings_count_once() -> None:
    """A sensor of 10 Hz whose messages come at 50 Hz says everything five times."""
    rng = np.random.default_rng(11)
    value = np.repeat(np.cumsum(0.01 * rng.standard_normal(2000)) * 0 + 0.02 * rng.standard_normal(2000), 5)
    assert noise_of(np.arange(value.size) * 0.02, value) == pytest.approx(0.02, rel=WITHIN)


def test_steps_that_hide_the_motion() -> None:
    """In steps of 0.05 m/s^2 a swing of 0.02 with noise of 0.01 is hidden, one with noise of half a step is not."""
    rng = np.random.default_rng(12)
    swing = 0.02 * np.sin(0.3 * np.arange(0.0, 300.0, 0.1))
    hidden, shown = (0.05 * np.rint((swing + each * rng.standard_normal(3000)) / 0.05) for each in (0.01, 0.025))
    assert hides_motion(hidden) and not hides_motion(shown)
    assert np.polyfit(swing, hidden, 1)[0] < 0.7 and np.polyfit(swing, shown, 1)[0] == pytest.approx(1.0, abs=0.1)
    assert not hides_motion(swing) and not hides_motion(np.zeros(3000)) and not hides_motion(np.full(9, np.nan))


def test_nothing_to_be_seen() -> None:
    """Constant readings and a handful of readings have no noise to be estimated."""
    time = np.arange(0.0, 100.0, 0.1)
    assert np.isnan(noise_of(time, np.full(time.size, -0.5)))
    assert np.isnan(noise_of(time[:20], np.random.default_rng(0).standard_normal(20)))
    assert np.isnan(noise_of(time, np.full(time.size, np.nan)))
