"""Coloured errors of readings against a Kalman filter whose state holds them, for the one motion that is linear."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

MASS, STEP, TAU, SMOOTHNESS = 0.44, 0.1, 2.5, 0.6
FORCE_RMS, Z_NOISE, MEMORY = 3e-4, 0.004, 0.8


def coloured(rng: np.random.Generator, time: Any, memory: float) -> Any:
    """A first-order process of standard deviation 1 at even times."""
    kept = math.exp(-float(time[1] - time[0]) / memory)
    errors = rng.standard_normal(len(time))
    for index in range(1, len(time)):
        errors[index] = kept * errors[index - 1] + math.sqrt(1.0 - kept**2) * errors[index]
    return errors


@pytest.fixture(scope="module")
def heaving() -> Any:
    """Evidence of a Lily without drag that hardly moves, of which depth alone is seen, with errors that last."""
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
    from cocorosim_ros.scenario.parts.platform import load_platform

    rng = np.random.default_rng(11)
    time = np.arange(0.0, 120.0, STEP)
    pose = np.full((len(time), 4), np.nan)
    pose[:, 2] = -1.0 + Z_NOISE * coloured(rng, time, MEMORY)
    streams = {"pose": Stream(time, pose, np.array([np.nan, np.nan, Z_NOISE, np.nan]))}
    commands = np.zeros((240, 3))
    log = RobotLog("lily_01", 0.5 * np.arange(240.0), commands, streams)
    platform = replace(load_platform("lily"), drag=0.0, yaw_drag=0.0)
    return Evidence(platform, (RecordingLog("heaving", 120.0, (log,)),))


def independent(pose: Any, start: Any) -> float:
    """Log-likelihood by a textbook filter with state z, w, random force, gust and the error of the reading."""
    from scipy.linalg import expm, solve_continuous_lyapunov

    middle, half = 2.0 / (SMOOTHNESS * TAU), 2.0 / (SMOOTHNESS * TAU) * math.sqrt(1.0 - SMOOTHNESS)
    slow, fast = middle - half, middle + half
    rates = np.array([[-slow, math.sqrt(slow * (slow + fast))], [0.0, -fast]])
    fade, stationary = expm(rates * STEP), solve_continuous_lyapunov(rates, np.diag([0.0, -2.0 * fast]))
    acting = 0.5 * (np.array([1.0, 0.0]) + fade[0])
    kept = math.exp(-STEP / MEMORY)
    transition, process = np.eye(5), np.zeros((5, 5))
    transition[0, 1] = STEP
    transition[0, 2:4], transition[1, 2:4] = 0.5 * STEP**2 / MASS * acting, STEP / MASS * acting
    transition[2:4, 2:4], transition[4, 4] = fade, kept
    process[2:4, 2:4] = FORCE_RMS**2 * (stationary - fade @ stationary @ fade.T)
    process[4, 4] = Z_NOISE**2 * (1.0 - kept**2)
    mean = np.array([start.mean[2], 0.0, 0.0, 0.0, 0.0])
    covariance = np.diag([start.spread[2] ** 2, start.spread[6] ** 2, 0.0, 0.0, Z_NOISE**2])
    covariance[2:4, 2:4] = FORCE_RMS**2 * stationary
    row, total = np.array([1.0, 0.0, 0.0, 0.0, 1.0]), 0.0
    for index, value in enumerate(pose.value[:, 2]):
        if index:
            mean, covariance = transition @ mean, transition @ covariance @ transition.T + process
        innovation, variance = value - row @ mean, row @ covariance @ row
        total -= 0.5 * (innovation**2 / variance + math.log(2.0 * math.pi * variance))
        gain = covariance @ row / variance
        mean, covariance = mean + gain * innovation, covariance - np.outer(gain, row @ covariance)
    return total


@pytest.fixture(scope="module")
def track(heaving: Any) -> Any:
    """The track of the one robot."""
    from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks

    return make_tracks(heaving)[0]


def numbers(track: Any, memory: float) -> Any:
    """The base model's row with the noise of this test."""
    from cocorosim_ros.diagnosis.fitting.base_model import base_rows
    from cocorosim_ros.diagnosis.tracks.columns import COLUMN

    row = base_rows([track])[0]
    row[COLUMN["random.heave_force"]] = math.log(FORCE_RMS)
    row[COLUMN["random.correlation"]] = math.log(TAU)
    row[COLUMN["random.smoothness"]] = math.log(SMOOTHNESS)
    row[COLUMN["reading.pose_z"]] = math.log(Z_NOISE)
    row[COLUMN["memory.pose_z"]] = math.log(memory)
    return row


def test_the_likelihood_is_that_of_a_filter_whose_state_holds_the_error(heaving: Any, track: Any) -> None:
    """To a hundredth of the 1,300 nats that colour is worth here; what comes in between two readings is left out."""
    pose = heaving.recordings[0].robots[0].streams["pose"]
    found = track.filter.full(numbers(track, MEMORY)).log_likelihood
    white = track.filter.full(numbers(track, 1e-9)).log_likelihood
    exact = independent(pose, track.filter.start)
    print(found, white, exact)
    assert abs(found - exact) < 0.01 * (exact - white)
