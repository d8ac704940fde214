"""Velocities whose noise is taken off, as far as what is left over is noise."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.steadied import steadied
from cocorosim_ros.diagnosis.evidence.streams.velocities import Velocities

STEP, NOISE = 0.1, 0.01  # s, m/s
TIME = STEP * np.arange(1200)


def motion(period: float, time: np.ndarray = TIME) -> np.ndarray:
    """Velocities (n, 3) that swing in a period [s]."""
    phase = 2.0 * np.pi * time / period
    return np.column_stack([1.0 + 0.3 * np.sin(phase), 0.1 * np.cos(phase), 0.05 * np.sin(phase + 1.0)])


def rms(value: np.ndarray) -> float:
    """Root of the mean square."""
    return float(np.sqrt(np.mean(value**2)))


@pytest.mark.parametrize(("period", "left"), [(60.0, 0.3), (20.0, 0.4), (8.0, 0.6)])
def test_the_slower_the_motion_the_less_noise_is_left(period: float, left: float) -> None:
    """Of white noise a parabola through n readings leaves 1.5 / sqrt(n); the motion itself stays."""
    noisy = motion(period) + NOISE * np.random.default_rng(1).standard_normal((len(TIME), 3))
    found = steadied(Velocities(TIME, noisy)).value - motion(period)
    assert all(rms(part) < left * NOISE for part in found.T), [rms(part) / NOISE for part in found.T]


def test_rates_lose_more_of_their_noise_than_velocities() -> None:
    """Differences over 0.2 s: a twentieth of the noise that raw readings have, where motion takes a minute."""
    noisy = motion(60.0) + NOISE * np.random.default_rng(2).standard_normal((len(TIME), 3))
    truth, raw, found = (
        each[2:] - each[:-2] for each in (motion(60.0), noisy, steadied(Velocities(TIME, noisy)).value)
    )
    assert rms(found - truth) < 0.05 * rms(raw - truth)


def test_swift_motion_stays_as_it_was_read() -> None:
    """Swings within half a second, of ten times the noise: no parabola follows them."""
    noisy = motion(0.5) + 0.001 * np.random.default_rng(3).standard_normal((len(TIME), 3))
    np.testing.assert_array_equal(steadied(Velocities(TIME, noisy)).value, noisy)


def test_nothing_is_taken_from_beyond_a_pause() -> None:
    """After a pause of a minute it goes at another speed: no reading beside it is drawn to the other side."""
    time = np.where(np.arange(len(TIME)) < 600, TIME, TIME + 60.0)
    speed = np.where(np.arange(len(TIME)) < 600, 0.5, 2.0)[:, None] * np.ones(3)
    noisy = speed + NOISE * np.random.default_rng(4).standard_normal(speed.shape)
    found = steadied(Velocities(time, noisy)).value
    assert np.abs(found - speed).max() < 3.0 * NOISE
    assert rms(found - speed) < 0.3 * NOISE


def test_few_velocities_stay() -> None:
    """Nine readings tell no noise."""
    few = Velocities(TIME[:9], motion(5.0)[:9])
    np.testing.assert_array_equal(steadied(few).value, few.value)
