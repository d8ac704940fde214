"""Tracks that leap: spikes go, exchanged robots are exchanged back, of the rest the longest stretch stays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.identities import with_true_identities
from cocorosim_ros.diagnosis.evidence.pose_jumps import find_jumps
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import full_speed
from cocorosim_ros.scenario.parts.platform import Platform

Swum = Callable[[Any], RobotLog]


def robot(swum: Swum, swim: Any, seed: int, away: float = 0.0) -> RobotLog:
    """A robot called after its seed, its poses `away` metres aside, every second second missing a pose."""
    log = swum(swim(seed, 120.0, topics=("pose", "compass")))
    stream = log.streams["pose"]
    value = stream.value + np.array([away, 0.0, 0.0, 0.0])
    return replace(log, name=f"lily_{seed:02d}", streams={**log.streams, "pose": replace(stream, value=value)})


def changed(log: RobotLog, value: np.ndarray) -> RobotLog:
    """The log with other poses."""
    return replace(log, streams={**log.streams, "pose": replace(log.streams["pose"], value=value)})


def test_tracks_that_do_not_leap_stay(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Also over gaps of ten seconds."""
    log = robot(swum, swim, 1)
    stream = log.streams["pose"]
    keep = (stream.time < 30.0) | (stream.time > 40.0)
    gapped = replace(stream, time=stream.time[keep], value=stream.value[keep])
    logs = [robot(swum, swim, 2), replace(log, streams={"pose": gapped})]
    found, remarks = with_true_identities(logs, lily_platform)
    assert remarks == [] and found == logs


def test_a_robot_that_starts_after_a_long_rest_does_not_leap(lily_platform: Platform, swum: Swum, swim: Any) -> None:
    """Its own usual speed is nothing, but the platform may swim."""
    log = robot(swum, swim, 1)
    stream = log.streams["pose"]
    way = np.maximum(stream.time - 117.0, 0.0) * 0.075
    still = changed(log, np.column_stack([way, 0 * way, 0 * way, 0 * way]))
    assert find_jumps(still.streams["pose"], lily_platform) == ()
    assert full_speed(lily_platform) == pytest.approx(0.075, rel=0.01)


def test_spikes_go(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Three poses, then one, far off; the rest stays, the heading counts on over them."""
    log = robot(swum, swim, 1)
    value = log.streams["pose"].value.copy()
    value[100:103, :2] += 0.5
    value[100:103, 3] += 3.0
    value[700, 1] -= 1.0
    (found,), (remark,) = with_true_identities([changed(log, value)], lily_platform)
    np.testing.assert_array_equal(
        found.streams["pose"].value[:, :3], np.delete(log.streams["pose"].value, [100, 101, 102, 700], axis=0)[:, :3]
    )
    assert "lily_01/pose: 4 poses" in remark and "first at 10.0 s" in remark


def test_exchanged_robots_are_exchanged_back(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """From 60 s on each has the other's track, from 90 s on not any more; a third one swims between them."""
    logs = [robot(swum, swim, 1), robot(swum, swim, 2, away=1.5), robot(swum, swim, 3, away=0.7)]
    first, second = (log.streams["pose"].value for log in logs[:2])
    middle = slice(600, 900)
    one, other = first.copy(), second.copy()
    one[middle], other[middle] = second[middle], first[middle]
    found, remarks = with_true_identities([changed(logs[0], one), changed(logs[1], other), logs[2]], lily_platform)
    for before, after in zip(logs, found, strict=True):
        expected, given = before.streams["pose"].value, after.streams["pose"].value
        np.testing.assert_array_equal(given[:, :3], expected[:, :3])
        turns = (given - expected)[:, 3] / (2 * np.pi)
        np.testing.assert_allclose(turns, np.rint(turns), atol=1e-9)
        assert np.abs(np.diff(given[:, 3])).max() < 0.5
    assert len(remarks) == 2
    assert all("lily_01/pose and lily_02/pose" in remark for remark in remarks)
    assert "60.0 s" in remarks[0] and "90.0 s" in remarks[1]


def test_robots_that_are_exchanged_as_they_meet(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Twelve centimetres apart, less than a hull, they are exchanged back all the same; alone such a leap is left."""
    logs = [robot(swum, swim, 1), replace(robot(swum, swim, 1, away=0.12), name="lily_02")]
    first, second = (log.streams["pose"].value for log in logs)
    late = (np.arange(len(first)) >= 500)[:, None]
    swapped = [changed(logs[0], np.where(late, second, first)), changed(logs[1], np.where(late, first, second))]
    found, (remark,) = with_true_identities(swapped, lily_platform)
    np.testing.assert_array_equal(found[0].streams["pose"].value[:, :2], first[:, :2])
    assert "50.0 s (0.1" in remark
    assert with_true_identities(swapped[:1], lily_platform) == (swapped[:1], [])


def test_exchanged_within_a_gap(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Both are lost for two seconds and come back as each other, their frames at other moments."""
    logs = [robot(swum, swim, 1), robot(swum, swim, 2, away=1.5)]
    poses = [log.streams["pose"] for log in logs]
    keep = (poses[0].time < 60.0) | (poses[0].time > 62.0)
    mixed = []
    for mine, theirs in (poses, poses[::-1]):
        late = mine.time > 61.0
        value = np.where(late[:, None], theirs.value, mine.value)[keep]
        mixed.append(replace(mine, time=mine.time[keep] + 0.03 * (mine is poses[1]), value=value))
    swapped = [replace(log, streams={"pose": pose}) for log, pose in zip(logs, mixed, strict=True)]
    found, (remark,) = with_true_identities(swapped, lily_platform)
    for before, after in zip(poses, found, strict=True):
        np.testing.assert_array_equal(after.streams["pose"].value[:, :3], before.value[keep, :3])
        assert (np.diff(after.streams["pose"].time) > 0.0).all()
        np.testing.assert_allclose(after.gaps, [(59.9, 62.1)], atol=0.05)
    assert "leap to each other's place at 62." in remark


def test_robots_that_leap_elsewhere_are_not_exchanged(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Two tracks leap at once, but not to each other: nobody is exchanged, the longer part of each stays."""
    logs = [robot(swum, swim, 1), robot(swum, swim, 2, away=1.5)]
    leaping = []
    for log in logs:
        value = log.streams["pose"].value.copy()
        value[400:, 1] += 4.0
        leaping.append(changed(log, value))
    found, remarks = with_true_identities(leaping, lily_platform)
    assert [len(log.streams["pose"].time) for log in found] == [800, 800]
    assert len(remarks) == 2 and all("at 40.0 s (4.00 m)" in remark for remark in remarks)
    assert all("from 40.0 to 119.9 s are used" in remark for remark in remarks)


def test_robots_without_poses_are_left_alone(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """There is nothing that could leap."""
    log = swum(swim(1, 120.0, topics=("compass",)))
    assert with_true_identities([log], lily_platform) == ([log], [])
