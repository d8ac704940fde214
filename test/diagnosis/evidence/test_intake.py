"""What physics is asked of: usable robots, streams put right, all of it said."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.intake import take_in
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog
from cocorosim_ros.scenario.parts.platform import Platform

Swum = Callable[[Any], RobotLog]


def clockwise(log: RobotLog) -> RobotLog:
    """The log with a compass that counts the wrong way."""
    compass = log.streams["compass"]
    return replace(log, streams={**log.streams, "compass": replace(compass, value=-compass.value)})


def evidence(platform: Platform, *recordings: tuple[RobotLog, ...]) -> Evidence:
    """Recordings of these robots."""
    return Evidence(platform, tuple(RecordingLog(f"bag{k}", 300.0, robots) for k, robots in enumerate(recordings)))


def test_clean_evidence_is_left_alone(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Nothing found, nothing said, nothing changed."""
    clean = evidence(lily_platform, (swum(swim(31, 120.0)),), (swum(swim(32, 120.0)),))
    intake = take_in(clean)
    assert intake.evidence == clean and intake.mixups == () and intake.reasons == ()


def test_a_mixup_is_put_right_and_said(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Of two robots with the same fault one mix-up is made; their recordings say so; the third stays."""
    good = swum(swim(31, 120.0))
    wrong = clockwise(good)
    intake = take_in(evidence(lily_platform, (wrong, replace(wrong, name="lily_02")), (replace(good, name="lily_03"),)))
    (mixup,) = intake.mixups
    assert mixup.robots == ("lily_01", "lily_02") and mixup.correction.topic == "compass"
    first, second = intake.evidence.recordings
    for robot in (*first.robots, *second.robots):
        turn = robot.streams["compass"].value - good.streams["compass"].value
        np.testing.assert_allclose(np.sin(turn), 0.0, atol=1e-9)
    assert len(first.remarks) == 2 and all("compass" in remark and "put right" in remark for remark in first.remarks)
    assert second.remarks == ()


def test_short_recordings_show_a_mixup_together(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Forty seconds are too few to correct a compass, and it is left out; five times forty are not."""
    logs = [clockwise(swum(swim(40 + seed, 40.0, topics=("pose", "compass")))) for seed in range(5)]
    alone = take_in(evidence(lily_platform, logs[:1]))
    assert [mixup.correction.wrong for mixup in alone.mixups] == ["it does not turn as the poses do"]
    assert sorted(alone.evidence.recordings[0].robots[0].streams) == ["pose"]
    intake = take_in(evidence(lily_platform, *((log,) for log in logs)))
    (mixup,) = intake.mixups
    assert mixup.correction.topic == "compass"
    assert all(len(recording.remarks) == 1 for recording in intake.evidence.recordings)


def test_robots_that_cannot_tell_are_left_out(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """With a remark; if nobody is left there are reasons and no robots."""
    good = swum(swim(31, 120.0))
    silent = replace(good, name="lily_02", command_time=np.empty(0), command=np.empty((0, 3)))
    intake = take_in(evidence(lily_platform, (good, silent)))
    (recording,) = intake.evidence.recordings
    assert [robot.name for robot in recording.robots] == ["lily_01"] and "lily_02" in recording.remarks[0]
    nobody = take_in(evidence(lily_platform, (silent,)))
    assert "no commands" in nobody.reasons[0] and nobody.evidence.recordings[0].robots == ()


def test_a_stream_that_cannot_be_put_right_is_left_out(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """An IMU on its side."""
    good = swum(swim(31, 120.0))
    imu = good.streams["imu"]
    turned = replace(imu, value=imu.value[:, [0, 3, 2, 1]] * np.array([0.0, 1.0, 1.0, 1.0]))
    intake = take_in(evidence(lily_platform, (replace(good, streams={**good.streams, "imu": turned}),)))
    (recording,) = intake.evidence.recordings
    assert sorted(recording.robots[0].streams) == ["compass", "pose", "pressure", "velocity"]
    assert "not used" in recording.remarks[0]


def test_speeds_that_differ_are_said(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """A velocity stream 1.3 times as fast as the poses is said; one of the same size, or of noise alone, is not."""
    good = swum(swim(33, 120.0))
    velocity = good.streams["velocity"]
    fast = replace(good, streams={**good.streams, "velocity": replace(velocity, value=1.3 * velocity.value)})
    (recording,) = take_in(evidence(lily_platform, (fast,))).evidence.recordings
    (remark,) = recording.remarks
    told = re.search(r"lily_01/velocity: its speeds are ([0-9.]+) times those of the poses", remark)
    assert told and float(told[1]) == pytest.approx(1.3, abs=0.04)
    noise = 0.2 * np.random.default_rng(0).standard_normal(velocity.value.shape)
    blind = replace(good, streams={**good.streams, "velocity": replace(velocity, value=noise)})
    (recording,) = take_in(evidence(lily_platform, (blind,))).evidence.recordings
    assert recording.remarks == ()
