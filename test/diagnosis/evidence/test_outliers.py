"""Faulty single readings are found, motion and noise are not."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.outliers import away, outliers


def test_one_and_two_faulty_readings() -> None:
    """A reading, and two in a row, far off a turning heading."""
    rng = np.random.default_rng(0)
    time = np.arange(0.0, 100.0, 0.1)
    value = 3.0 * np.sin(0.5 * time) + 0.02 * rng.standard_normal(time.size)
    value[[100, 500, 501]] += [2.7, -2.0, -2.1]
    assert np.flatnonzero(outliers(value, 0.02)).tolist() == [100, 500, 501]


def test_noise_and_fast_motion_are_none() -> None:
    """White noise, steps that stay, and a steep rise from rest."""
    rng = np.random.default_rng(1)
    value = 0.02 * rng.standard_normal(5000)
    value[2000:] += 3.0
    value[3000:] += np.minimum(np.arange(2000) * 0.5, 40.0)
    assert not outliers(value, 0.02).any()


def test_readings_not_given_stay_out() -> None:
    """NaN is neither faulty nor a neighbour."""
    value = 0.02 * np.random.default_rng(2).standard_normal(500)
    value[[10, 11, 13]] = np.nan
    value[12] = 5.0
    assert np.flatnonzero(outliers(value, 0.02)).tolist() == [12]


def test_what_is_frequent_is_no_fault() -> None:
    """A sensor that says something else in every tenth reading is said to be noisy, not faulty; so is one at rest."""
    value = 0.02 * np.random.default_rng(3).standard_normal(500)
    value[::10] += 5.0
    assert not outliers(value, 0.02).any()
    assert not outliers(np.append(np.zeros(99), 1.0), float("nan")).any()
    assert not outliers(np.array([0.0, 9.0, 0.0]), 0.1).any()


def test_a_heading_that_leaps_away_and_back() -> None:
    """A dozen readings from confused marks on a robot that spins at 15 rad/s; two leaps within one second."""
    rng = np.random.default_rng(6)
    time = np.arange(0.0, 20.0, 0.01)
    heading = np.cumsum(0.15 * np.sin(0.7 * time)) + 0.004 * rng.standard_normal(time.size)
    heading[400:412] -= 2.6
    heading[700:703] += 2.0
    heading[760:790] += 2.0
    expected = [*range(400, 412), *range(700, 703), *range(760, 790)]
    assert np.flatnonzero(away(time, heading, 0.004)).tolist() == expected


def test_a_bow_that_is_taken_for_the_stern() -> None:
    """Three of a hundred frames are turned by half a turn, by which the heading leaps back or on around."""
    rng = np.random.default_rng(8)
    time = np.arange(0.0, 60.0, 0.02)
    heading = 2.0 * np.sin(0.4 * time) + 0.005 * rng.standard_normal(time.size)
    turned = rng.random(time.size) < 0.03
    turned[[0, -1]] = False
    angle = np.unwrap(np.mod(heading + np.pi * turned, 2.0 * np.pi))
    found = away(time, angle, 0.005)
    assert np.count_nonzero(found != turned) <= 0.03 * np.count_nonzero(turned)
    assert not away(time, np.unwrap(np.mod(heading, 2.0 * np.pi)), 0.005).any()
    spinning = 30.0 * time  # 1.8 rad between two frames of every third: nothing can be followed
    assert not away(time[::3], spinning[::3], 0.005).any()


def test_a_heading_that_stays_where_it_leapt_is_none() -> None:
    """Set down again by hand, it faces elsewhere; and half of all readings cannot be faults."""
    time = np.arange(0.0, 20.0, 0.01)
    heading = 0.004 * np.random.default_rng(7).standard_normal(time.size)
    heading[1000:] += 2.0
    assert not away(time, heading, 0.004).any()
    flicker = np.where(np.arange(time.size) % 40 < 20, 0.0, 2.0)
    assert not away(time, heading + flicker, 0.004).any()
