"""The filter against a Kalman filter written out in NumPy, for the one motion that is linear: heave without drag."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

MASS, STEP, TAU, SMOOTHNESS = 0.44, 0.1, 2.5, 0.6
FORCE_RMS, Z_NOISE, PRESSURE_NOISE = 3e-4, 0.002, 7.0


@pytest.fixture(scope="module")
def heaving() -> Any:
    """Evidence of a Lily without drag, of whom depth alone is seen, twice."""
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
    from cocorosim_ros.scenario.parts.platform import load_platform

    rng = np.random.default_rng(5)
    time = np.arange(0.0, 30.0, STEP)
    depth = -1.0 + 0.1 * np.sin(0.3 * time)
    pose = np.full((len(time), 4), np.nan)
    pose[:, 2] = depth + Z_NOISE * rng.standard_normal(len(time))
    pressure = 101325.0 - 9810.0 * depth[::2, None] + PRESSURE_NOISE * rng.standard_normal((len(time[::2]), 1))
    streams = {
        "pose": Stream(time, pose, np.array([np.nan, np.nan, Z_NOISE, np.nan])),
        "pressure": Stream(time[::2], pressure, np.array([PRESSURE_NOISE])),
    }
    commands = np.column_stack([np.zeros(60), np.zeros(60), rng.uniform(-0.02, 0.02, 60)])
    log = RobotLog("lily_01", 0.5 * np.arange(60.0), commands, streams)
    platform = replace(load_platform("lily"), drag=0.0, yaw_drag=0.0)
    return Evidence(platform, (RecordingLog("heaving", 30.0, (log,)),))


def random_force() -> tuple[Any, Any]:
    """Transition over a step and stationary covariance (2, 2) of force and gust, by exponential and Lyapunov."""
    from scipy.linalg import expm, solve_continuous_lyapunov

    middle, half = 2.0 / (SMOOTHNESS * TAU), 2.0 / (SMOOTHNESS * TAU) * math.sqrt(1.0 - SMOOTHNESS)
    slow, fast = middle - half, middle + half
    rates = np.array([[-slow, math.sqrt(slow * (slow + fast))], [0.0, -fast]])
    return expm(rates * STEP), solve_continuous_lyapunov(rates, np.diag([0.0, -2.0 * fast]))


def independent(evidence: Any, start: Any) -> float:
    """Log-likelihood by a textbook filter with state z, w, random force and gust; the force acts by its mean."""
    log = evidence.recordings[0].robots[0]
    fade, stationary = random_force()
    acting = 0.5 * (np.array([1.0, 0.0]) + fade[0])
    transition = np.eye(4)
    transition[0, 1] = STEP
    transition[0, 2:], transition[1, 2:] = 0.5 * STEP**2 / MASS * acting, STEP / MASS * acting
    transition[2:, 2:] = fade
    process, covariance = np.zeros((4, 4)), np.zeros((4, 4))
    process[2:, 2:] = FORCE_RMS**2 * (stationary - fade @ stationary @ fade.T)
    mean = np.array([start.mean[2], 0.0, 0.0, 0.0])
    covariance[:2, :2] = np.diag([start.spread[2] ** 2, start.spread[6] ** 2])
    covariance[2:, 2:] = FORCE_RMS**2 * stationary
    total = 0.0
    pose, pressure = log.streams["pose"], log.streams["pressure"]
    for index, moment in enumerate(pose.time):
        if index:
            command = log.command[int((moment - STEP) / 0.5 + 1e-6), 2]
            force = command * 1000.0 * 9.81 * 10e-6
            mean = transition @ mean + force * np.array([0.5 * STEP**2 / MASS, STEP / MASS, 0.0, 0.0])
            covariance = transition @ covariance @ transition.T + process
        readings = [(np.array([1.0, 0.0, 0.0, 0.0]), 0.0, pose.value[index, 2], Z_NOISE)]
        if index % 2 == 0:
            row = np.array([-9810.0, 0.0, 0.0, 0.0])
            readings.append((row, 101325.0, pressure.value[index // 2, 0], PRESSURE_NOISE))
        for row, constant, value, noise in readings:
            innovation = value - constant - row @ mean
            variance = row @ covariance @ row + noise**2
            total -= 0.5 * (innovation**2 / variance + math.log(2.0 * math.pi * variance))
            gain = covariance @ row / variance
            mean = mean + gain * innovation
            covariance = covariance - np.outer(gain, row @ covariance)
    return total


def numbers(track: Any) -> Any:
    """The base model's row with the noise of this test."""
    from cocorosim_ros.diagnosis.fitting.base_model import base_rows
    from cocorosim_ros.diagnosis.tracks.columns import COLUMN

    row = base_rows([track])[0]
    row[COLUMN["random.heave_force"]] = math.log(FORCE_RMS)
    row[COLUMN["random.correlation"]] = math.log(TAU)
    row[COLUMN["random.smoothness"]] = math.log(SMOOTHNESS)
    row[COLUMN["reading.pose_z"]] = math.log(Z_NOISE)
    row[COLUMN["reading.pressure"]] = math.log(PRESSURE_NOISE)
    return row


def test_the_likelihood_is_that_of_a_textbook_filter(heaving: Any) -> None:
    """Where the motion is linear, the log-likelihood of 450 readings agrees to 1e-6."""
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks

    track = make_tracks(heaving)[0]
    passed = track.filter.full(numbers(track))
    assert passed.believed.all()
    assert passed.log_likelihood == pytest.approx(independent(heaving, track.filter.beginning.start), abs=1e-6)


def test_the_smoother_knows_more_than_any_reading(heaving: Any) -> None:
    """Given all readings the depth is known three times better than one reading shows it, and says so."""
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks

    track = make_tracks(heaving)[0]
    course = track.filter.smoothed(numbers(track))
    truth = -1.0 + 0.1 * np.sin(0.3 * course.time)
    assert np.sqrt(np.mean((course.mean[:, 2] - truth) ** 2)) < Z_NOISE / 3.0
    assert course.spread[150, 2] < course.spread[-1, 2] < Z_NOISE


@pytest.fixture(scope="module")
def carried_off(heaving: Any) -> Any:
    """The track and row of one who is 10 cm elsewhere from half time on, as if someone had carried it."""
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks

    (recording,) = heaving.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    moved = replace(pose, value=pose.value + 0.1 * (pose.time >= 15.0)[:, None])
    alone = replace(log, streams={"pose": moved})
    track = make_tracks(replace(heaving, recordings=(replace(recording, robots=(alone,)),)))[0]
    return track, numbers(track)


def test_a_robot_that_was_lost_is_found_again(carried_off: Any) -> None:
    """Fifty standard deviations are not believed, but pull the model there; at the end it agrees with what is read."""
    track, row = carried_off
    believed = track.filter.full(row).believed
    assert believed[:140].all() and not believed[150:155].any()
    assert believed[-50:].all()


def test_what_is_not_believed_pulls_as_far_with_every_number(carried_off: Any) -> None:
    """A slope along no change is nothing, to the bit, after doubted readings too."""
    track, row = carried_off
    slope = np.ones(len(track.timeline.kind))
    track.filter.slope(row, track.filter.full(row), 1.0, slope)
    np.testing.assert_array_equal(slope, 0.0)


def test_a_number_at_its_bound_does_not_hold_the_others_back() -> None:
    """Of two that pull at each other, the one pressing against its bound is left out: the other goes all its way."""
    from cocorosim_ros.diagnosis.fitting.solving import step_within
    from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown

    owners = [Owner(PLATFORM, ("lily_01",), name, unit) for name, unit in (("drag", "kg/m"), ("yaw_drag", "N m s^2"))]
    pair = [Unknown(owners[0], "drag", (0,), 1.0, bounds=(-1.0, 1.0)), Unknown(owners[1], "yaw_drag", (0,), 1.0)]
    matrix, score = np.array([[2.0, 1.5], [1.5, 2.0]]), np.array([1.0, 1.0])
    np.testing.assert_allclose(step_within(matrix, score, pair, np.array([1.0, 0.0])), [0.0, 0.5])
    np.testing.assert_allclose(step_within(matrix, -score, pair, np.array([1.0, 0.0])), [-2.0 / 7.0, -2.0 / 7.0])
