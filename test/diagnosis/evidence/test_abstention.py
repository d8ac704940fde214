"""Recordings that cannot tell anything are found, with what and where; those that can are not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.abstention import reasons_to_abstain, without_unusable
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.scenario.parts.platform import Platform

Swum = Callable[[Any], RobotLog]


def evidence(platform: Platform, *robots: RobotLog) -> Evidence:
    """One recording of these robots."""
    return Evidence(platform, (RecordingLog("tank/bag", 60.0, robots),))


@pytest.fixture
def log(swum: Swum, swim: Any) -> RobotLog:
    """A minute of swimming about, all topics."""
    return swum(swim(20, 60.0))


def only(log: RobotLog, *topics: str) -> RobotLog:
    """The log with these topics alone."""
    return replace(log, streams={topic: log.streams[topic] for topic in topics})


@pytest.mark.parametrize(
    "topics", [("pose",), ("pressure",), ("imu",), ("compass",), ("velocity",), ("pressure", "imu")]
)
def test_any_stream_is_enough(log: RobotLog, lily_platform: Platform, topics: tuple[str, ...]) -> None:
    """A minute of commands and one moving stream is no reason to abstain."""
    assert reasons_to_abstain(evidence(lily_platform, only(log, *topics))) == ()


def test_no_commands(log: RobotLog, lily_platform: Platform) -> None:
    """Said with recording and robot."""
    silent = replace(log, command_time=np.empty(0), command=np.empty((0, 3)))
    (reason,) = reasons_to_abstain(evidence(lily_platform, silent))
    assert reason.startswith("tank/bag: lily_01 has no commands")


def test_no_usable_stream(log: RobotLog, lily_platform: Platform) -> None:
    """None, or a handful of readings."""
    (reason,) = reasons_to_abstain(evidence(lily_platform, only(log)))
    assert "too few readings in 60.0 s (none)" in reason
    pose = log.streams["pose"]
    few = replace(log, streams={"pose": replace(pose, time=pose.time[:19], value=pose.value[:19])})
    (reason,) = reasons_to_abstain(evidence(lily_platform, few))
    assert "too few readings in 60.0 s (19 of pose)" in reason


def test_five_seconds(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Too short to tell anything."""
    (reason,) = reasons_to_abstain(evidence(lily_platform, swum(swim(21, 5.0))))
    assert "at the same time for 5.0 s" in reason


def test_short_recordings_add_up(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Four time constants of coasting are the least, m / (k v) = 0.44 / (1.7778 * 0.075) = 3.3 s for a Lily."""
    short = RecordingLog("tank/short", 8.0, (swum(swim(22, 8.0)),))
    (reason,) = reasons_to_abstain(Evidence(lily_platform, (short,)))
    assert "make 8.0 s in all; 13 s are the least for a lily" in reason
    assert reasons_to_abstain(Evidence(lily_platform, (short, short))) == ()


def test_commands_after_the_readings(log: RobotLog, lily_platform: Platform) -> None:
    """What was commanded when nobody looked does not count."""
    late = replace(log, command_time=log.command_time + 55.0)
    (reason,) = reasons_to_abstain(evidence(lily_platform, late))
    assert "at the same time for 5.0 s" in reason


def thinned(log: RobotLog, factor: float, *topics: str) -> RobotLog:
    """The log with times of some streams, or of all and the commands, so many times as far apart."""
    streams = {
        topic: replace(each, time=each.time * factor if not topics or topic in topics else each.time)
        for topic, each in log.streams.items()
    }
    return replace(log, command_time=log.command_time * (1 if topics else factor), streams=streams)


def test_seconds_that_are_milliseconds(log: RobotLog, lily_platform: Platform) -> None:
    """Ten times the 3.3 s for which a Lily coasts lie between all readings; one stream that is quicker is enough."""
    quickest = min(float(np.median(np.diff(each.time))) for each in log.streams.values())
    (reason,) = reasons_to_abstain(evidence(lily_platform, thinned(log, 1.01 * 33.0 / quickest)))
    assert "has readings 33.3 s apart in the median" in reason
    assert "a lily coasts for 3.3 s" in reason and "the unit of 'time' in the map" in reason
    assert reasons_to_abstain(evidence(lily_platform, thinned(log, 0.99 * 33.0 / quickest))) == ()
    others = [topic for topic in log.streams if topic != "pressure"]
    assert reasons_to_abstain(evidence(lily_platform, thinned(log, 1000.0, *others))) == ()


def test_constant_commands(log: RobotLog, lily_platform: Platform) -> None:
    """They are named; a single actuator that is varied is enough."""
    constant = np.tile([0.5, 0.6, 0.0], (len(log.command_time), 1))
    (reason,) = reasons_to_abstain(evidence(lily_platform, replace(log, command=constant)))
    assert "same commands throughout (left 0.5, right 0.6, buoyancy 0)" in reason
    constant[300:, 2] = 0.1
    assert reasons_to_abstain(evidence(lily_platform, replace(log, command=constant))) == ()


def test_commands_that_change_from_recording_to_recording(log: RobotLog, lily_platform: Platform) -> None:
    """Recordings of constant commands tell enough together where these differ, and say so where they do not."""
    gentle, strong = (
        RecordingLog(f"tank/{name}", 60.0, (replace(log, command=np.tile(command, (len(log.command_time), 1))),))
        for name, command in (("gentle", [0.5, 0.6, 0.0]), ("strong", [0.5, 0.8, 0.0]))
    )
    both = Evidence(lily_platform, (gentle, strong))
    assert reasons_to_abstain(both) == ()
    assert [len(recording.robots) for recording in without_unusable(both).recordings] == [1, 1]
    assert reasons_to_abstain(Evidence(lily_platform, (gentle,)), beside=(strong,)) == ()
    alike = reasons_to_abstain(Evidence(lily_platform, (gentle, replace(gentle, origin="tank/again"))))
    assert len(alike) == 2 and "buoyancy 0), as in all other recordings of it, so that" in alike[1]


def test_a_robot_that_never_moves(log: RobotLog, lily_platform: Platform) -> None:
    """All streams show noise alone, whatever is commanded; one that moves is enough."""
    rng = np.random.default_rng(0)
    still = {}
    for topic, stream in log.streams.items():
        noise = rng.standard_normal(stream.value.shape) * stream.noise
        still[topic] = replace(stream, value=np.median(stream.value, axis=0) + noise)
    (reason,) = reasons_to_abstain(evidence(lily_platform, replace(log, streams=still)))
    assert "never moves: there is nothing but noise in compass, imu, pose, pressure, velocity;" in reason
    for topic in still:
        moving = {**still, topic: log.streams[topic]}
        assert reasons_to_abstain(evidence(lily_platform, replace(log, streams=moving))) == ()


def test_a_robot_that_stands_exactly_still(log: RobotLog, lily_platform: Platform) -> None:
    """Readings that never change have no noise to compare with."""
    time = np.arange(0.0, 60.0, 0.1)
    pose = Stream(time, np.tile([1.0, 2.0, -0.5, 0.3], (600, 1)), np.full(4, np.nan))
    (reason,) = reasons_to_abstain(evidence(lily_platform, replace(log, streams={"pose": pose})))
    assert "never moves: there is nothing but noise in pose;" in reason


def test_a_robot_that_moves_a_little(log: RobotLog, lily_platform: Platform) -> None:
    """Two centimetres are seen through three millimetres of noise, because a second holds ten readings."""
    pose = log.streams["pose"]
    noise = np.random.default_rng(1).standard_normal(pose.value.shape) * pose.noise
    moving = noise + np.linspace(0.0, 0.02, len(pose.time))[:, None] * np.array([1.0, 0.0, 0.0, 0.0])
    assert (
        reasons_to_abstain(evidence(lily_platform, replace(log, streams={"pose": replace(pose, value=moving)}))) == ()
    )


def test_one_robot_that_can_tell_is_enough(log: RobotLog, lily_platform: Platform) -> None:
    """The others are left out, and their recording says why."""
    silent = replace(log, name="lily_02", command_time=np.empty(0), command=np.empty((0, 3)))
    both = evidence(lily_platform, silent, log)
    assert reasons_to_abstain(both) == ()
    (recording,) = without_unusable(both).recordings
    assert [robot.name for robot in recording.robots] == ["lily_01"]
    assert len(recording.remarks) == 1 and "lily_02 has no commands" in recording.remarks[0]
