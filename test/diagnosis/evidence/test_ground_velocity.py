"""A velocity over ground is that of the poses, mean and all; what is one through the water instead is said."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.consistency import speed_sentences
from cocorosim_ros.diagnosis.evidence.frames.correction import corrected
from cocorosim_ros.diagnosis.evidence.frames.kinematics import contradictions
from cocorosim_ros.diagnosis.evidence.frames.motion import motion_of
from cocorosim_ros.diagnosis.evidence.frames.needed_corrections import needed_corrections
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.scenario.parts.platform import Platform

CURRENT = (0.03, -0.02)  # m/s; the robot makes 0.04 m/s in the root mean square
Swum = Callable[[Any], RobotLog]


def over_ground(log: RobotLog, current: tuple[float, float] = CURRENT) -> RobotLog:
    """The log with a log over ground beside it: the one through the water, and the current along the robot's axes."""
    water, pose = log.streams["velocity"], log.streams["pose"]
    yaw = np.interp(water.time, pose.time, pose.value[:, 3])
    ground = water.value.copy()
    ground[:, 0] += current[0] * np.cos(yaw) + current[1] * np.sin(yaw)
    ground[:, 1] += current[1] * np.cos(yaw) - current[0] * np.sin(yaw)
    return replace(log, streams={**log.streams, "ground_velocity": replace(water, value=ground)})


def changed(log: RobotLog, change: Callable[[Stream], Any]) -> RobotLog:
    """The log with other values of the velocity over ground."""
    stream = log.streams["ground_velocity"]
    return replace(log, streams={**log.streams, "ground_velocity": replace(stream, value=change(stream))})


def only(log: RobotLog, *topics: str) -> RobotLog:
    """The log with these streams alone."""
    return replace(log, streams={name: log.streams[name] for name in topics})


@pytest.mark.parametrize("seed", range(6))
def test_what_fits_is_left(swum: Swum, swim: Any, lily_platform: Platform, seed: int) -> None:
    """Beside all streams, beside poses, and without poses, where the current is as fast as the robot."""
    log = over_ground(swum(swim(seed, 300.0 if seed % 2 else 120.0, CURRENT)))
    for kept in (
        log,
        only(log, "pose", "ground_velocity"),
        only(log, "compass", "imu", "ground_velocity"),
        only(log, "compass", "ground_velocity", "velocity"),
        only(log, "ground_velocity"),
    ):
        assert needed_corrections(kept, lily_platform) == ()
        assert list(contradictions(motion_of(kept, lily_platform))) == []
    assert list(speed_sentences(only(log, "pose", "ground_velocity"), lily_platform)) == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda v: [-v[0], -v[1], v[2]], "signs of x and y are flipped"),
        (lambda v: [v[0], -v[1], -v[2]], "sign of z is flipped"),
        (lambda v: [1000 * v[0], 1000 * v[1], 1000 * v[2]], "millimetres"),
    ],
)
def test_axes_and_units_are_put_right(
    swum: Swum, swim: Any, lily_platform: Platform, change: Callable[[Any], Any], words: str
) -> None:
    """In a current, too, since means do not count for axes."""
    right = over_ground(swum(swim(4, 300.0, CURRENT)))
    wrong = changed(right, lambda stream: np.array(change(stream.value.T)).T)
    (found,) = needed_corrections(wrong, lily_platform)
    assert found.topic == "ground_velocity" and words in found.wrong
    mended = corrected(wrong, [found]).streams["ground_velocity"].value
    np.testing.assert_allclose(mended, right.streams["ground_velocity"].value, atol=1e-12)


def test_earth_velocities_in_body_columns(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """East and north, as satellite receivers give them, are turned into body axes by the yaw of the poses."""
    right = over_ground(swum(swim(4, 300.0, CURRENT)))

    def in_world(stream: Stream) -> Any:
        yaw = np.interp(stream.time, right.streams["pose"].time, right.streams["pose"].value[:, 3])
        u, v, w = stream.value.T
        return np.column_stack([u * np.cos(yaw) - v * np.sin(yaw), u * np.sin(yaw) + v * np.cos(yaw), w])

    (found,) = needed_corrections(changed(right, in_world), lily_platform)
    assert found.topic == "ground_velocity" and found.into_body and "world axes" in found.wrong


def test_a_velocity_of_something_else_is_not_used(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """No axes make it that of the poses; the one through the water beside it is no reason."""
    log = over_ground(swum(swim(5, 300.0, CURRENT)))

    def other(stream: Stream) -> Any:
        swings = np.sin(2.0 * np.pi * np.outer(stream.time, [1 / 31.0, 1 / 23.0, 1 / 17.0]))
        return 0.05 * swings

    found = list(contradictions(motion_of(changed(log, other), lily_platform)))
    assert [(each.topic, each.matrix) for each in found] == [("ground_velocity", None)]


@pytest.mark.parametrize("current", [(0.012, -0.008), CURRENT, (0.06, -0.04)])
def test_one_through_the_water_in_its_place_is_said(
    swum: Swum, swim: Any, lily_platform: Platform, current: tuple[float, float]
) -> None:
    """With the drift, which is the current, to 2 mm/s: poses and readings have as much noise over a few seconds."""
    log = over_ground(swum(swim(6, 300.0, current)), (0.0, 0.0))
    (said,) = [each for each in speed_sentences(log, lily_platform) if each.startswith("lily_01/ground_velocity")]
    told = re.search(r"the poses move by \(([-0-9.]+), ([-0-9.]+)\) m/s in the world against it", said)
    assert told and "call it 'velocity'" in said
    np.testing.assert_allclose([float(told[1]), float(told[2])], current, atol=0.002)


@pytest.mark.parametrize("current", [CURRENT, (-0.015, 0.04)])
def test_one_over_ground_in_place_of_the_other_is_said(
    swum: Swum, swim: Any, lily_platform: Platform, current: tuple[float, float]
) -> None:
    """By the commands, under which poses drift as the velocity does; the platform's numbers are off by a quarter.

    The drift is told to a quarter of the current. Of the velocity through the water nothing is said but its size.
    """
    log = over_ground(swum(swim(6, 300.0, current)), current)
    wrong = replace(log, streams={"pose": log.streams["pose"], "velocity": log.streams["ground_velocity"]})
    (said,) = speed_sentences(wrong, lily_platform)
    told = re.search(r"it has the drift of \(([-0-9.]+), ([-0-9.]+)\) m/s in the world that the poses have", said)
    assert told and said.startswith("lily_01/velocity") and said.endswith("call it 'ground_velocity'.")
    assert abs(complex(float(told[1]), float(told[2])) - complex(*current)) < 0.25 * abs(complex(*current))
    assert not [each for each in speed_sentences(log, lily_platform) if "drift" in each or "against it" in each]


@pytest.mark.parametrize("seed", range(8))
def test_nothing_is_said_in_water_at_rest(swum: Swum, swim: Any, lily_platform: Platform, seed: int) -> None:
    """Whatever the numbers of the vehicle, the length, and whether it turns; both velocities are the same there."""
    log = over_ground(swum(swim(40 + seed, 60.0 if seed % 2 else 300.0, straight=seed % 4 == 3)), (0.0, 0.0))
    assert list(speed_sentences(log, lily_platform)) == []


def test_a_scale_is_no_drift(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """On a straight course one that shows 30 % too much drifts as well, which is told by the size of its speeds."""
    log = over_ground(swum(swim(7, 300.0, (0.0, 0.0), straight=True)), (0.0, 0.0))
    assert list(speed_sentences(log, lily_platform)) == []
    (said,) = speed_sentences(changed(log, lambda stream: 1.3 * stream.value), lily_platform)
    told = re.search(r"lily_01/ground_velocity: its speeds are ([0-9.]+) times those of the poses", said)
    assert told and float(told[1]) == pytest.approx(1.3, abs=0.06)
