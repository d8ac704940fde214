"""Coloured errors of readings against a Kalman filter whose state holds them, for the one motion that is linear."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.streams.noise import noise_of
from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.fitting.base_model import base_rows
from cocorosim_ros.diagnosis.fitting.coloured_readings import with_coloured_readings
from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.unknowns import READING, Owner, Unknown
from cocorosim_ros.diagnosis.showing.noise_levels import noise_levels
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, MEMORY_COLUMNS, READING_MEMORY, WANDER
from cocorosim_ros.diagnosis.tracks.last_of_kind import last_of_kind
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.scenario.parts.platform import load_platform

MASS, STEP, TAU, SMOOTHNESS = 0.44, 0.1, 2.5, 0.6
FORCE_RMS, Z_NOISE, MEMORY = 3e-4, 0.004, 0.8
DURATION = 180.0  # s, of a swim
PLACE_NOISE, WANDERED = 0.004, 0.01  # m, and m in a second
NOISE = {"pose": (0.002, 0.002, 0.002, 0.01), "compass": (0.02,), "pressure": (8.0,), "imu": (0.004,)}


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
    return make_tracks(heaving)[0]


def numbers(track: Any, memory: float) -> Any:
    """The base model's row with the noise of this test."""
    row = base_rows([track])[0]
    row[COLUMN["random.heave_force"]] = math.log(FORCE_RMS)
    row[COLUMN["random.correlation"]] = math.log(TAU)
    row[COLUMN["random.smoothness"]] = math.log(SMOOTHNESS)
    row[COLUMN["reading.pose_z"]] = math.log(Z_NOISE)
    row[COLUMN["memory.pose_z"]] = math.log(memory)
    return row


def test_the_likelihood_is_that_of_a_filter_whose_state_holds_the_error(heaving: Any, track: Any) -> None:
    """To a thousandth of what colour is worth here; the force that comes in between two readings is left out."""
    pose = heaving.recordings[0].robots[0].streams["pose"]
    found = track.filter.full(numbers(track, MEMORY)).log_likelihood
    white = track.filter.full(numbers(track, 1e-9)).log_likelihood
    exact = independent(pose, track.filter.beginning.start)
    assert exact - white > 100.0
    assert abs(found - exact) < 1e-3 * (exact - white)


def test_next_to_no_memory_is_white(track: Any) -> None:
    """To the last digit, whether the memory is the least number that there is or a thousandth of the step."""
    none, some = (track.filter.full(numbers(track, memory)) for memory in (np.finfo(float).tiny, 1e-3 * STEP))
    np.testing.assert_array_equal(none.innovation, some.innovation)
    np.testing.assert_array_equal(none.variance, some.variance)


def test_a_reading_far_behind_the_last_one_is_taken_as_it_is() -> None:
    """Of each kind by itself: 0.3 s is near, 2 s is not, and the first has none before it."""
    kind, moment = np.array([0, 1, 0, 1, 0]), np.array([0.0, 0.1, 0.3, 2.1, 0.4])
    before, gap = last_of_kind(kind, moment, 0.5)
    assert before.tolist() == [-1, -1, 0, -1, 2]
    np.testing.assert_allclose(gap, [0.0, 0.0, 0.3, 0.0, 0.1])


def wandering(rng: np.random.Generator, time: Any, step: float) -> Any:
    """A random walk of `step` [m] in a second."""
    return step * math.sqrt(float(time[1] - time[0])) * rng.standard_normal(len(time)).cumsum()


def drifting(place: Any, spread: Any, step: float) -> float:
    """Log-likelihood of places along one axis by a textbook filter: speed without force, and a random walk from 0."""
    transition, process = np.array([[1.0, STEP], [0.0, 1.0]]), np.diag([step**2 * STEP, 0.0])
    mean, covariance = np.zeros(2), np.diag([spread[0] ** 2, spread[1] ** 2])
    row, total = np.array([1.0, 0.0]), 0.0
    for index, value in enumerate(place):
        if index:
            mean, covariance = transition @ mean, transition @ covariance @ transition.T + process
        innovation, variance = value - row @ mean, row @ covariance @ row + PLACE_NOISE**2
        total -= 0.5 * (innovation**2 / variance + math.log(2.0 * math.pi * variance))
        gain = covariance @ row / variance
        mean, covariance = mean + gain * innovation, covariance - np.outer(gain, row @ covariance)
    return total


def test_the_likelihood_of_wandering_places_is_that_of_a_textbook_filter() -> None:
    """A Lily without drag or forces, which a compass shows to point along x for good; places are white and wander."""
    rng = np.random.default_rng(8)
    time = np.arange(0.0, 60.0, STEP)
    pose = np.full((len(time), 4), np.nan)
    pose[:, 3] = 1e-5 * rng.standard_normal(len(time))
    for column in range(2):
        pose[:, column] = wandering(rng, time, WANDERED) + PLACE_NOISE * rng.standard_normal(len(time))
    streams = {"pose": Stream(time, pose, np.array([PLACE_NOISE, PLACE_NOISE, np.nan, 1e-5]))}
    log = RobotLog("lily_01", 0.5 * np.arange(120.0), np.zeros((120, 3)), streams)
    still = replace(load_platform("lily"), drag=0.0, yaw_drag=0.0)
    (track,) = make_tracks(Evidence(still, (RecordingLog("drifting", 60.0, (log,)),)))
    row = base_rows([track])[0]
    for name in ("random.force", "random.heave_force", "random.moment"):
        row[COLUMN[name]] = math.log(1e-12)
    row[COLUMN["reading.pose_xy"]], row[COLUMN["reading.pose_yaw"]] = math.log(PLACE_NOISE), math.log(1e-5)
    start, found, exact = track.filter.beginning.start, {}, {}
    for step in (0.5 * WANDERED, WANDERED):
        row[COLUMN[WANDER]] = math.log(step)
        passed = track.filter.full(row)
        assert passed.believed.all()
        found[step] = passed.log_likelihood
        exact[step] = sum(
            drifting(pose[:, column] - start.mean[column], start.spread[[column, 4 + column]], step)
            for column in range(2)
        )
    gained = exact[WANDERED] - exact[0.5 * WANDERED]
    assert gained > 30.0
    assert found[WANDERED] - found[0.5 * WANDERED] == pytest.approx(gained, abs=0.01)


def with_errors(evidence: Any, memory: float) -> Any:
    """Add first-order errors of this memory [s], of the usual size, to exact readings; 0 for white ones."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    rng, streams = np.random.default_rng(4), {}
    for name, stream in log.streams.items():
        sizes = np.array(NOISE[name])
        count, width = len(stream.time), len(sizes)
        columns = [coloured(rng, stream.time, memory) if memory else rng.standard_normal(count) for _ in range(width)]
        value = stream.value.copy()
        value[:, :width] += sizes * np.column_stack(columns)
        noise = np.full(value.shape[1], np.nan)
        noise[:width] = [noise_of(stream.time, each) for each in value[:, :width].T]
        streams[name] = Stream(stream.time, value, noise)
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


@pytest.fixture(scope="module")
def swum(swim: Any) -> Any:
    """Function of a memory [s]: evidence of one swim with errors that last so long."""
    exact = swim(load_platform("lily"), DURATION, seed=31, blur=0.0)
    return lambda memory: with_errors(exact, memory)


@pytest.mark.parametrize("memory", [0.4, 1.2])
def test_lasting_errors_of_all_instruments_are_found_in_the_first_fit(swum: Any, memory: float) -> None:
    """Memory of depth and compass, and the noise as it was put in, which differences do not show.

    The coefficient k = exp(-gap / T) of n readings has the asymptotic variance (1 - k^2) / n, and so the logarithm of T
    a standard deviation of sqrt((1 - k^2) / n) T / (k gap); that of the size is about sqrt(T / (n gap)).
    """
    fit = base_fit(swum(memory))
    levels = noise_levels(fit)
    for kind, size, gap in (("pose_z", 0.002, 0.1), ("compass", 0.02, 0.2)):
        kept = math.exp(-gap / memory)
        width = math.sqrt((1.0 - kept**2) * gap / DURATION) * memory / (kept * gap)
        assert levels[f"memory.{kind}"].value == pytest.approx(memory, rel=3.0 * width)
        assert levels[f"reading.{kind}"].value == pytest.approx(size, rel=3.0 * math.sqrt(memory / DURATION))
    with_memory = {unknown.column for unknown in fit.noise if unknown.column.startswith("memory.")}
    assert with_memory >= {"memory.pose_xy", "memory.pose_yaw", "memory.pressure"}


def test_the_reading_before_is_expected_where_the_robot_was(swim: Any) -> None:
    """Of an exact swim whose pump changes its force at grid points, depth is foreseen as well as with white errors."""
    (track,) = make_tracks(swim(load_platform("lily"), 60.0, seed=5, disturbance=0.0, blur=0.0))
    white = base_rows([track])[0]
    for kind, size in (("pose_z", 0.002), ("pressure", 8.0)):
        white[COLUMN[f"reading.{kind}"]] = math.log(size)
    lasting = white.copy()
    lasting[MEMORY_COLUMNS] = math.log(0.5)
    with_white, with_lasting = track.filter.full(white), track.filter.full(lasting)
    for kind in ("pose_z", "pressure"):
        chosen = track.timeline.kind == KIND_NAMES.index(kind)
        errors = [np.sqrt(np.mean(each.innovation[chosen] ** 2)) for each in (with_white, with_lasting)]
        assert 0.0 < errors[1] < errors[0]  # a difference of errors is less than these


def test_white_errors_have_no_memory(swum: Any) -> None:
    """Neither in the first fit, nor when it is asked again; nor where an instrument is off by a constant."""
    white = swum(0.0)
    (recording,) = white.recordings
    (log,) = recording.robots
    pressure = log.streams["pressure"]
    off = replace(log, streams={**log.streams, "pressure": replace(pressure, value=pressure.value + 500.0)})
    for evidence in (white, replace(white, recordings=(replace(recording, robots=(off,)),))):
        fit = base_fit(evidence)
        assert not any(unknown.column in READING_MEMORY for unknown in fit.noise)
        assert with_coloured_readings(fit, fit) is None


def of_a_tracker_alone(evidence: Any) -> Any:
    """The same swim as a tracker alone saw it."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams={"pose": pose}),)),))


@pytest.mark.parametrize("memory", [0.3, 0.0])
def test_errors_of_one_tracker_last_where_white_ones_need_incredible_water(swum: Any, memory: float) -> None:
    """Errors of three readings are found though one instrument saw them; white ones get no memory.

    As white errors the former need a random force above all thrust, 10 mN: 2 mm in 0.3 s are 22 mm/s^2, times 0.44 kg.
    """
    fit = base_fit(of_a_tracker_alone(swum(memory)))
    levels = noise_levels(fit)
    found = {unknown.column for unknown in fit.noise if unknown.column in READING_MEMORY}
    assert bool(found) == bool(memory)
    assert levels["random.force"].value < 0.01
    if memory:
        assert levels["memory.pose_xy"].value == pytest.approx(memory, rel=0.3)
        assert levels["reading.pose_xy"].value == pytest.approx(0.002, rel=0.2)


def test_a_memory_that_gains_nothing_is_taken_away(swum: Any) -> None:
    """A model with a memory that its readings do not show gets the plain model back."""
    plain = base_fit(swum(0.0))
    memory = Unknown(Owner(READING, ("lily_01",), "compass_memory", "s"), "memory.compass", (0,), base=math.log(0.3))
    added = evaluated(replace(plain, noise=(*plain.noise, memory), q_noise=np.append(plain.q_noise, 0.0)))
    found = with_coloured_readings(added, added)
    assert found is not None and found.noise == plain.noise
    assert found.objective == pytest.approx(plain.objective, abs=0.5)


def test_nothing_is_named_for_lasting_errors(swum: Any) -> None:
    """Errors of half a second in all instruments, and nothing hidden."""
    diagnosis = diagnose(swum(0.5), lambda words, share: None)
    assert diagnosis.effects == ()
    assert diagnosis.verdict in ("consistent", "recalibrate")
    assert diagnosis.noise["memory.pose_z"].value == pytest.approx(0.5, rel=0.3)
    assert any("Errors of the compass of lily_01 last for about 0." in said for said in diagnosis.remarks)


def with_wander(evidence: Any, step: float) -> Any:
    """Let the places of an exact swim with white errors wander by `step` [m] in a second."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    rng, pose = np.random.default_rng(14), log.streams["pose"]
    value = pose.value.copy()
    for column in range(2):
        value[:, column] += wandering(rng, pose.time, step)
    noise = pose.noise.copy()
    noise[:2] = [noise_of(pose.time, value[:, column]) for column in range(2)]
    streams = {**log.streams, "pose": Stream(pose.time, value, noise)}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def test_places_that_wander_beside_white_errors_are_found_as_they_are(swum: Any) -> None:
    """As those of a satellite receiver: 2 mm of a single reading, 10 mm in a second, and nothing is named for it.

    Of n = 1800 steps of 3 mm, each seen through white errors of 2 mm at both ends, the variance is known to about
    sqrt(2 / n) (1 + 2 * 4 / 10), and its root to half of that, 3 %.
    """
    diagnosis = diagnose(with_wander(swum(0.0), 0.01), lambda words, share: None)
    assert diagnosis.noise[WANDER].value == pytest.approx(0.01, rel=0.1)
    assert diagnosis.noise["reading.pose_xy"].value == pytest.approx(0.002, rel=0.2)
    assert diagnosis.effects == ()
    assert any("wanders as that of a satellite receiver, by about" in said for said in diagnosis.remarks)


def test_places_whose_errors_have_one_memory_do_not_wander(swum: Any) -> None:
    """Nor do those with white errors, see above."""
    fit = base_fit(swum(0.4))
    found = with_coloured_readings(fit, fit) or fit
    columns = {unknown.column for unknown in found.noise}
    assert "memory.pose_xy" in columns and WANDER not in columns
