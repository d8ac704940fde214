"""Poses are read from any recording: sorted, each moment once, what was dropped is counted."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some
from scipy.spatial.transform import Rotation

from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.bags.tracks import pose_track, read_poses
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store

POSE = "geometry_msgs/msg/PoseStamped"
ANGLES = some.floats(-3.1, 3.1)


def pose(
    stamp_ns: int,
    position: tuple[float, float, float] = (0, 0, 0),
    quaternion: Any = (0, 0, 0, 1),
    frame: str = "world",
) -> Any:
    """A PoseStamped."""
    seconds, nanoseconds = divmod(stamp_ns, 10**9)
    return build(
        POSE,
        {
            "header": {"stamp": {"sec": seconds, "nanosec": nanoseconds}, "frame_id": frame},
            "pose": {
                "position": dict(zip("xyz", position, strict=True)),
                "orientation": dict(zip("xyzw", quaternion, strict=True)),
            },
        },
    )


def cdr(*arguments: Any, **options: Any) -> bytes:
    """The bytes of a PoseStamped."""
    return serialize(pose(*arguments, **options))


@given(some.lists(some.tuples(some.integers(0, 10**12), ANGLES, some.floats(-1e3, 1e3)), unique_by=lambda row: row[0]))
def test_stamps_positions_and_yaw(rows: list[tuple[int, float, float]]) -> None:
    """Header stamps, positions and yaw come back, sorted by stamp whatever the order of recording."""
    messages = [cdr(stamp, (x, 2 * x, -x), Rotation.from_euler("z", yaw).as_quat()) for stamp, yaw, x in rows]
    track = pose_track(messages)
    expected = sorted(rows)
    assert track.stamp_ns.tolist() == [row[0] for row in expected]
    np.testing.assert_array_equal(track.position, np.array([(x, 2 * x, -x) for _, _, x in expected]).reshape(-1, 3))
    np.testing.assert_allclose(track.yaw, [row[1] for row in expected], atol=1e-12)
    assert (track.duplicates, track.conflicts, track.not_finite, track.unreadable) == (0, 0, 0, 0)


@given(ANGLES, some.floats(-1.5, 1.5), ANGLES, some.floats(0.1, 10))
def test_yaw_of_a_tilted_body(yaw: float, pitch: float, roll: float, length: float) -> None:
    """Yaw is that of the REP 103 angles (yaw, pitch, roll), also of quaternions not of length one."""
    quaternion = length * Rotation.from_euler("ZYX", [yaw, pitch, roll]).as_quat()
    np.testing.assert_allclose(pose_track([cdr(0, (0, 0, 0), quaternion)]).yaw, [yaw], atol=1e-9)


def test_duplicates_and_conflicts_are_dropped_and_counted() -> None:
    """The same pose twice is a duplicate; another pose of the same stamp a conflict: the first one stays."""
    track = pose_track([cdr(5, (1, 0, 0)), cdr(3), cdr(5, (1, 0, 0)), cdr(5, (2, 0, 0)), cdr(5, (1, 0, 0))])
    assert track.stamp_ns.tolist() == [3, 5]
    assert track.position[1].tolist() == [1, 0, 0]
    assert (track.duplicates, track.conflicts) == (2, 1)


def test_poses_that_are_no_numbers_are_dropped_and_counted() -> None:
    """NaN and infinite poses are dropped; bytes that are no pose are dropped and counted apart."""
    track = pose_track(
        [cdr(1, (math.nan, 0, 0)), cdr(2), cdr(3, (0, math.inf, 0)), b"", b"\x00\x01\x00\x00" + bytes(40)]
    )
    assert track.stamp_ns.tolist() == [2]
    assert (track.not_finite, track.unreadable) == (2, 2)


def test_position_without_attitude() -> None:
    """A camera that sees no heading leaves the quaternion zero: the position counts, the yaw is NaN."""
    track = pose_track([cdr(1, (1, 2, -3), (0, 0, 0, 0))])
    assert track.position.tolist() == [[1, 2, -3]]
    assert np.isnan(track.yaw).all()


def test_frames_of_any_length_and_byte_orders() -> None:
    """Messages of several publishers on one topic, with other frame_ids and byte order, are all read."""
    messages = [cdr(index, (index, 0, 0), frame="w" * index) for index in range(12)]
    swapped = type_store().serialize_cdr(pose(12, (12, 0, 0)), POSE, little_endian=False)
    track = pose_track([*messages, bytes(swapped)])
    assert track.position[:, 0].tolist() == list(range(13))
    assert track.stamp_ns.tolist() == list(range(13))
    assert "world" in track.frames and len(track.frames) == 13


def test_time_counts_from_the_first_pose() -> None:
    """Seconds since the robot's first pose."""
    assert pose_track([cdr(4_000_000_000), cdr(2_500_000_000)]).time.tolist() == [0.0, 1.5]
    assert pose_track([]).time.tolist() == []


def test_robots_are_found_by_topic_and_type(tmp_path: Path) -> None:
    """NAMESPACE/pose of type PoseStamped is a robot at any depth; other types and names are none."""
    channels = [
        Channel("/lily_02/pose", POSE),
        Channel("/tank/a/lily_01/pose", POSE),
        Channel("/lily_03/pose", "geometry_msgs/msg/Pose"),
        Channel("/lily_04/goal_pose", POSE),
        Channel("/silent/pose", POSE),
    ]
    with BagWriter(tmp_path / "bag", channels) as bag:
        for index, channel in enumerate(channels[:4]):
            data = serialize(build(channel.type_name)) if channel.type_name != POSE else cdr(index)
            bag.write(channel.topic, 99, 99, data)
    tracks = read_poses(tmp_path / "bag")
    assert list(tracks) == ["lily_02", "silent", "tank/a/lily_01"]
    assert [len(track.stamp_ns) for track in tracks.values()] == [1, 0, 1]


@pytest.fixture
def long_recording(tmp_path: Path) -> Path:
    """100 000 poses of ten robots."""
    fields = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
    packed = PackedMessage([pose(0)] * 10, fields)
    topics = [f"/lily_{robot:02d}/pose" for robot in range(10)]
    values = np.random.default_rng(2).normal(size=(10, 7))
    with BagWriter(tmp_path / "bag", [Channel(topic, POSE) for topic in topics]) as bag:
        for tick in range(10_000):
            for topic, data in zip(topics, packed.encode(tick, values), strict=True):
                bag.write(topic, tick, tick, data)
    return tmp_path / "bag"


def test_a_hundred_thousand_poses_take_a_moment(long_recording: Path) -> None:
    """Reading 100 000 poses takes less than 5 s even on a busy machine (0.3 s on an idle one)."""
    start = time.process_time()
    tracks = read_poses(long_recording)
    assert time.process_time() - start < 5
    assert sum(len(track.stamp_ns) for track in tracks.values()) == 100_000
