"""Poses kept in a file are those that are read into memory, to the last bit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.wire.bags import kept_poses
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.bags.kept_poses import keep_poses
from cocorosim_ros.wire.bags.tracks import read_poses
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build

POSE = "geometry_msgs/msg/PoseStamped"
FIELDS = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]


def assert_same(bag: Path) -> None:
    """The stamps of all poses, and all poses in any order."""
    kept, read = keep_poses(read_bag(bag)), read_poses(bag)
    assert list(kept) == list(read)
    for name, track in read.items():
        assert kept[name].stamp_ns.tolist() == track.stamp_ns.tolist()
        for rows in (np.arange(len(track.stamp_ns)), np.random.default_rng(3).permutation(len(track.stamp_ns))):
            position, yaw = kept[name].at(rows)
            assert position.tobytes() == track.position[rows].tobytes()
            assert yaw.tobytes() == track.yaw[rows].tobytes()


@pytest.mark.parametrize("at_once", [1, 7, 1_000_000])
def test_poses_in_order(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, pose_rows: Callable[..., Any], record: Any, at_once: int
) -> None:
    """Three robots with more poses than memory keeps, decoded one by one, by the seven and all at once."""
    monkeypatch.setattr(kept_poses, "MESSAGES_AT_ONCE", at_once)
    record(tmp_path / "bag", pose_rows(900, 3))
    assert_same(tmp_path / "bag")


def test_robots_share_stamps_that_are_the_same(tmp_path: Path, pose_rows: Callable[..., Any], record: Any) -> None:
    """Those of a simulation are in memory once, however many robots there are."""
    record(tmp_path / "bag", pose_rows(900, 3))
    first, *others = keep_poses(read_bag(tmp_path / "bag")).values()
    assert len(others) == 2 and all(other.stamp_ns is first.stamp_ns for other in others)


@pytest.mark.parametrize("at_once", [5, 1_000_000])
def test_poses_out_of_order_repeated_and_broken(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, at_once: int) -> None:
    """One robot after the other, stamps that jump and come twice, NaN, no heading, bytes that are no pose, silence."""
    monkeypatch.setattr(kept_poses, "MESSAGES_AT_ONCE", at_once)
    rng = np.random.default_rng(4)
    packed = PackedMessage([build(POSE, {"header": {"frame_id": "world"}})], FIELDS)
    topics = ["/b/pose", "/tank/a/pose", "/silent/pose"]
    with BagWriter(tmp_path / "bag", [Channel(topic, POSE) for topic in topics]) as bag:
        for topic in topics[:2]:
            for row, stamp in enumerate(rng.integers(0, 60, 100).tolist()):
                values = rng.normal(size=(1, 7))
                values[0, rng.integers(7)] = np.nan if row % 9 == 0 else 1.0
                values[0, 3:] *= row % 10 != 3
                data = packed.encode(stamp, values)[0]
                bag.write(topic, row, row, data if row % 11 else data[:40])
    assert_same(tmp_path / "bag")
    kept = keep_poses(read_bag(tmp_path / "bag"))
    assert [len(each.stamp_ns) > 30 for each in kept.values()] == [True, False, True]
    assert np.isnan(kept["b"].at(np.arange(len(kept["b"].stamp_ns)))[1]).any()
