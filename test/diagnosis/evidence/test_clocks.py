"""Stamps that count from another zero, jump or run fast are told by the log times, and aligned where they must be."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.clocks import clock_skews, has_clock_of_commands, on_one_clock
from cocorosim_ros.diagnosis.evidence.gather import gather_recording
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.evidence.topic_rows import TopicRows
from cocorosim_ros.scenario.parts.platform import Platform

SECOND = 10**9
EPOCH = 1_750_000_000 * SECOND


def rows(topic: str, stamp: Any, log: Any | None = None, robot: str = "lily_01") -> TopicRows:
    """A topic with these stamps and log times [s]; values count the messages."""
    stamps = EPOCH + np.rint(np.asarray(stamp) * SECOND).astype(np.int64)
    logs = stamps if log is None else EPOCH + np.rint(np.asarray(log) * SECOND).astype(np.int64)
    return TopicRows(robot, topic, stamps, logs, np.arange(len(stamps))[:, None].astype(float))


def seconds(topic: TopicRows) -> np.ndarray:
    """Stamps [s] since EPOCH."""
    return np.asarray((topic.stamp_ns - EPOCH) / SECOND)


TIME = np.arange(0.0, 60.0, 0.1)


def test_one_clock_is_left_alone() -> None:
    """Delays of transport, waits of seconds and late bursts change no stamp."""
    rng = np.random.default_rng(0)
    log = TIME + rng.exponential(0.01, TIME.size)
    log[200:240] = np.maximum(log[200:240], log[240])
    log[300] += 2.5
    topics = [rows("pose", TIME, log), rows("compass", TIME + 0.03, TIME + 0.05)]
    found, remarks = on_one_clock(topics)
    assert remarks == []
    for before, after in zip(topics, found, strict=True):
        np.testing.assert_array_equal(before.stamp_ns, after.stamp_ns)


@pytest.mark.parametrize("offset", [-1_750_000_000.0, 3600.0, -2.0])
def test_another_zero(offset: float) -> None:
    """The odd one out among three is shifted, to within the transport; the sentence says how far and which."""
    topics = [rows("pose", TIME, TIME + 0.01), rows("compass", TIME + offset, TIME + 0.012), rows("imu", TIME, TIME)]
    found, remarks = on_one_clock(topics)
    np.testing.assert_allclose(seconds(found[1]), TIME, atol=0.02)
    np.testing.assert_array_equal(found[0].stamp_ns, topics[0].stamp_ns)
    assert [each.shifted for each in found] == [0.0, pytest.approx(-offset, abs=0.02), 0.0]
    (remark,) = remarks
    told = re.search(r"lily_01/compass: the stamps are ([0-9.e+]+) s", remark)
    assert told and float(told[1]) == pytest.approx(abs(offset), rel=1e-5, abs=0.02)
    assert ("behind" if offset < 0 else "ahead") in remark


def test_of_two_clocks_the_recorders_counts() -> None:
    """Where two topics differ and none decides, the one that agrees with the log times stays."""
    found, _ = on_one_clock([rows("pose", TIME - 1e6, TIME), rows("thruster_command", TIME, TIME)])
    np.testing.assert_allclose(seconds(found[0]), TIME, atol=1e-6)
    np.testing.assert_allclose(seconds(found[1]), TIME, atol=1e-6)


def test_all_stamps_of_another_zero_are_one_clock() -> None:
    """A recorder with another clock than all robots is nobody's fault: only differences count."""
    topics = [rows("pose", TIME, TIME + 500.0), rows("compass", TIME, TIME + 500.01)]
    found, remarks = on_one_clock(topics)
    assert remarks == [] and seconds(found[0])[0] == 0.0


def test_a_small_offset_is_said_and_left() -> None:
    """Half a second may be latency, which the diagnosis estimates itself."""
    topics = [rows("pose", TIME, TIME), rows("imu", TIME, TIME), rows("compass", TIME - 0.5, TIME)]
    found, (remark,) = on_one_clock(topics)
    np.testing.assert_array_equal(found[2].stamp_ns, topics[2].stamp_ns)
    assert "lily_01/compass" in remark and "0.50 s behind" in remark


def test_a_clock_that_starts_anew() -> None:
    """Stamps that begin again at zero half way are put behind the first half."""
    stamp = np.where(TIME < 30.0, TIME, TIME - 30.0)
    found, remarks = on_one_clock([rows("pose", stamp, TIME), rows("imu", TIME, TIME)])
    np.testing.assert_allclose(seconds(found[0]), TIME, atol=1e-6)
    assert len(remarks) == 1 and "messages 301 to 600 of 600" in remarks[0]


def test_single_strays_are_left_out() -> None:
    """A few stamps of zero, or of next year, are no measurement."""
    stamp = TIME.copy()
    stamp[[5, 77]], stamp[100] = -1_750_000_000.0, 3e7
    found, (remark,) = on_one_clock([rows("pose", stamp, TIME), rows("imu", TIME, TIME)])
    np.testing.assert_array_equal(found[0].values[:, 0], np.delete(np.arange(600), [5, 77, 100]))
    assert "3 messages" in remark


@pytest.mark.parametrize("rate", [3e-4, -3e-4])
def test_skew(rate: float) -> None:
    """A clock that runs 300 ppm fast or slow is seen to within its error, which is some ppm."""
    rng = np.random.default_rng(1)
    time = np.arange(0.0, 600.0, 0.1)
    log = time + 0.001 + rng.exponential(0.004, time.size)
    even = rows("pose", time, log), rows("imu", time + 0.01, time + 0.012 + rng.exponential(0.004, time.size))
    skews = clock_skews([*even, rows("compass", time * (1.0 + rate), log)])
    assert skews[2].rate == pytest.approx(rate, abs=5e-6)
    assert 1e-8 < skews[2].error < 5e-6
    assert abs(skews[0].rate) < 5e-6


def test_no_skew_is_read_where_log_times_are_stamps() -> None:
    """A simulated recording, a short one and an empty one tell nothing."""
    skews = clock_skews(
        [rows("pose", TIME), rows("imu", TIME[:100], TIME[:100] + 0.01 * TIME[:100]), rows("velocity", [])]
    )
    assert all(np.isnan(skew.rate) for skew in skews)


@pytest.mark.parametrize(("late", "shared"), [(0.0, True), (2e-4 * 60.0, False)])
def test_rows_of_one_table_have_one_clock(late: float, shared: bool) -> None:
    """A skew of them is no hypothesis, of a stream whose stamps leave those of the commands it is one."""
    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
    from cocorosim_ros.diagnosis.fitting.candidate import _shows

    stamps = TIME * (1.0 + late / 60.0)
    pose = Stream(stamps, np.zeros((600, 4)), np.full(4, 0.01))
    log = RobotLog("ship", TIME, np.zeros((600, 1)), {"pose": pose, "imu": replace(pose, time=stamps[:0])})
    assert has_clock_of_commands(log, "pose") is shared
    assert not has_clock_of_commands(log, "imu")
    track: Any = SimpleNamespace(log=log, timeline=SimpleNamespace(kinds=("pose_x", "pose_y", "pose_yaw")))
    by_id = {(entry.id, entry.topic): entry for entry in ENTRIES}
    assert _shows(by_id["clock_skew", "pose"], [track]) is not shared
    assert _shows(by_id["sensor_latency", "pose"], [track])


def test_nothing_at_all() -> None:
    """No topics, and topics without messages, are no error."""
    assert on_one_clock([]) == ([], [])
    empty = rows("pose", [])
    found, remarks = on_one_clock([empty, rows("imu", TIME)])
    assert len(found[0].stamp_ns) == 0 and remarks == []


def test_in_a_recording(
    circle: dict[str, Any], record: Callable[..., Path], lily_platform: Platform, is_said: Callable[..., bool]
) -> None:
    """The streams come out aligned, with their skews, and the remarks are the recording's."""
    compass = circle["/lily_01/compass"]
    circle["/lily_01/compass"] = compass.changed(stamp=compass.stamp * 1.002 - 1e9, log=compass.stamp + 0.004)
    for name in ("/lily_01/pose", "/lily_01/thruster_command"):
        jitter = np.random.default_rng(2).exponential(0.002, 400)
        circle[name] = replace(circle[name], log=circle[name].stamp + jitter)
    recording = gather_recording(record(circle), lily_platform)
    stream = recording.robots[0].streams["compass"]
    np.testing.assert_allclose(stream.time, compass.stamp, atol=0.1)
    assert stream.skew == pytest.approx(0.002, abs=2e-4)
    assert is_said(recording.remarks, "lily_01/compass", "1e+09 s behind", "shifted")
    assert is_said(recording.remarks, "lily_01/compass", "ppm fast")
    assert not is_said(recording.remarks, "lily_01/pose", "ppm")
