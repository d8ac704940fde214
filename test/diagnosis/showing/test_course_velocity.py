"""Velocities that a diagnosis tells, as the overlay has them: against the simulator's own, and against poses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.foretelling.free_runs import held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.unseen import unseen_parts
from cocorosim_ros.diagnosis.report.overlay import write_overlay
from cocorosim_ros.diagnosis.showing.course_velocity import course_velocities
from cocorosim_ros.scenario.parts.platform import load_platform

CURRENT = (0.012, -0.007)  # m/s, world x and y
SECONDS, SEED, STEP = 120.0, 5, 0.05
POSES = 0.002  # m, noise of a reading ten times a second


class Told(NamedTuple):
    """What was found of a swim: the numbers of each topic, the free runs, and how sure the smoother is."""

    topics: dict[str, Any]  # by topic (n, 5): time [s], u, v, w [m/s], r [rad/s]
    frames: set[str]
    runs: tuple[Any, ...]
    spread: Any  # (points, 4) standard deviation of u, v, w, r
    truth: Any  # (rows, 8) states every STEP


@pytest.fixture(scope="module")
def told(swim: Callable[..., Any], truth_of: Callable[..., Any], tmp_path_factory: pytest.TempPathFactory) -> Told:
    """Two minutes of a Lily in a current that its platform's file has."""
    from hidden_effects import hiding

    platform = hiding(load_platform("lily"), {"steady_current": dict(zip("xy", CURRENT, strict=True))})
    base = base_fit(swim(platform, SECONDS, seed=SEED))
    courses, runs = smoothed_tracks(base), held_out_free_runs(unseen_parts(base), base).runs
    found = Diagnosis(
        *("consistent", "", (), (), (), (), (), {}), free_runs=runs, velocities=course_velocities(base, courses)
    )
    folder = tmp_path_factory.mktemp("velocities") / "overlay"
    write_overlay(found, 0.15, folder)
    topics, frames = read(folder)
    return Told(topics, frames, runs, courses[0].spread[:, 4:8], truth_of(platform, SECONDS, SEED))


def read(folder: Path) -> tuple[dict[str, Any], set[str]]:
    """Times [s] and numbers of every velocity, and their frames, by the stamps of messages as `rosbags` reads them."""
    rows: dict[str, list[list[float]]] = {}
    frames = set()
    with AnyReader([folder]) as reader:
        for connection, _, data in reader.messages([each for each in reader.connections if "velocity" in each.topic]):
            message: Any = reader.deserialize(data, connection.msgtype)
            stamp, linear = message.header.stamp, message.twist.linear
            row = [stamp.sec + 1e-9 * stamp.nanosec, linear.x, linear.y, linear.z, message.twist.angular.z]
            rows.setdefault(connection.topic, []).append(row)
            frames.add(message.header.frame_id)
    return {topic: np.array(each) for topic, each in rows.items()}, frames


def true_velocity(told: Told, time: Any) -> tuple[Any, Any]:
    """Velocities (n, 4) over ground and through the water of the simulator's states at times (n,) [s]."""
    states = told.truth[np.rint(time / STEP).astype(int)]
    (east, north), yaw, ground = CURRENT, states[:, 3], states[:, 4:8]
    water = np.column_stack([east * np.cos(yaw) + north * np.sin(yaw), north * np.cos(yaw) - east * np.sin(yaw)])
    return ground, np.column_stack([ground[:, :2] - water, ground[:, 2:]])


def test_topics_and_frame(told: Told) -> None:
    """Through the water and, since the water moves, over ground; twists in the robot's own frame."""
    assert sorted(told.topics) == [
        f"/lily_01/{of}/{kind}" for of in ("by_model", "smoothed") for kind in ("ground_velocity", "velocity")
    ]
    assert told.frames == {"lily_01/base_link"}


def test_smoothed_velocity_is_the_simulator_s(told: Told) -> None:
    """Over the whole recording; errors are those that the smoother expects of the noise, and those are small.

    Poses alone would show the velocity over a second with sqrt(2) times their noise divided by the root of the ten
    readings in it, times the root of two halves; a model that knows the thrust does better.
    """
    grounds, waters = told.topics["/lily_01/smoothed/ground_velocity"], told.topics["/lily_01/smoothed/velocity"]
    time = waters[:, 0]
    assert time[0] < 1.0 and time[-1] > SECONDS - 1.0 and np.diff(time).max() < 0.15
    points = np.rint(np.linspace(0, len(told.spread) - 1, len(time))).astype(int)
    for shown, truth in zip((grounds, waters), true_velocity(told, time), strict=True):
        error = shown[:, 1:] - truth
        assert np.abs(error[:, :3]).mean() < POSES * np.sqrt(2.0) / np.sqrt(10.0)
        ratio = np.sqrt(np.mean((error / told.spread[points]) ** 2, axis=0))
        assert (ratio > 0.5).all() and (ratio < 1.6).all(), ratio
    assert np.abs(grounds[:, 1:3] - waters[:, 1:3]).max() > 0.01


def test_foretold_velocity_integrates_to_the_foretold_pose(told: Told) -> None:
    """Speeds over ground, turned by the heading, add up to the way of the same free run; so does the turn."""
    foretold = told.topics["/lily_01/by_model/ground_velocity"]
    assert len(told.runs) > 1
    for run in told.runs:
        rows = foretold[(foretold[:, 0] > run.time[0] - 1e-6) & (foretold[:, 0] < run.time[-1] + 1e-6)]
        assert rows[:, 0] == pytest.approx(run.time, abs=1e-6)
        path, (ahead, left, up, turn) = run.augmented, rows[:, 1:].T
        cosine, sine = np.cos(path[:, 3]), np.sin(path[:, 3])
        speeds = np.column_stack([ahead * cosine - left * sine, ahead * sine + left * cosine, up, turn])
        steps = 0.5 * (speeds[1:] + speeds[:-1]) * np.diff(run.time)[:, None]
        # The trapezoid errs by step^2/12 times what the rate has changed: 0.1 s, 0.1 m/s^2 and 5 rad/s^2 at most.
        assert path[0] + np.cumsum(steps, axis=0) == pytest.approx(path[1:], abs=0.1**2 / 12 * 5.0)


def test_foretold_velocity_through_the_water_lacks_the_current(told: Told) -> None:
    """What it moves less than over ground is the current, along the heading that the free run has."""
    for run in told.runs:
        lacking = run.velocity.over_ground - run.velocity.through_water
        east, north = CURRENT
        yaw = run.augmented[:, 3]
        assert lacking[:, 0] == pytest.approx(east * np.cos(yaw) + north * np.sin(yaw), abs=1e-9)
        assert lacking[:, 1] == pytest.approx(north * np.cos(yaw) - east * np.sin(yaw), abs=1e-9)
        assert not lacking[:, 2:].any()


def test_still_water_has_one_velocity(told: Told, tmp_path: Path) -> None:
    """Where both are the same, that through the water stands for both."""
    (run, *_) = told.runs
    velocity = replace(run.velocity, over_ground=run.velocity.through_water)
    found = Diagnosis(
        *("consistent", "", (), (), (), (), (), {}), free_runs=(replace(run, velocity=velocity),)
    )  # fmt: skip
    write_overlay(found, 0.15, tmp_path / "overlay")
    assert list(read(tmp_path / "overlay")[0]) == ["/lily_01/by_model/velocity"]
