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


def test_one_through_the_water_in_its_place_is_said(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """With the drift, which is the current, to 2 mm/s: poses and readings have as much noise over a few seconds.

    In a current as fast as the robot the sizes of the speeds say it first.
    """
    slow = (0.012, -0.008)
    log = over_ground(swum(swim(6, 300.0, slow)), (0.0, 0.0))
    (said,) = [each for each in speed_sentences(log, lily_platform) if each.startswith("lily_01/ground_velocity")]
    told = re.search(r"the poses move by \(([-0-9.]+), ([-0-9.]+)\) m/s in the world against it", said)
    assert told and "call it 'velocity'" in said
    np.testing.assert_allclose([float(told[1]), float(told[2])], slow, atol=0.002)
    fast = over_ground(swum(swim(6, 300.0, (0.06, -0.04))), (0.0, 0.0))
    (said,) = [each for each in speed_sentences(fast, lily_platform) if each.startswith("lily_01/ground_velocity")]
    assert "times those of the poses" in said and "which is called 'velocity'" in said


def test_a_scale_is_no_drift(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """On a straight course one that shows 13 % too much drifts as well, which is not said to be a current."""
    log = over_ground(swum(swim(7, 300.0, (0.0, 0.0), straight=True)), (0.0, 0.0))
    assert list(speed_sentences(changed(log, lambda stream: 1.13 * stream.value), lily_platform)) == []
