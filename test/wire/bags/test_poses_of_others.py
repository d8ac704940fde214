"""Recordings of others are looked at without a map: Odometry, poses under other names, frames of /tf."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.library.recording import read_recording
from cocorosim_ros.study.metrics import sampling
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store

COUNT = 30
X, YAW = 0.2 * np.arange(COUNT), 0.1 * np.arange(COUNT)
POSE, ODOMETRY, TRANSFORMS = "geometry_msgs/msg/PoseStamped", "nav_msgs/msg/Odometry", "tf2_msgs/msg/TFMessage"


def pose(row: int) -> dict[str, Any]:
    """A pose as geometry_msgs/Pose."""
    turn = {"z": math.sin(YAW[row] / 2), "w": math.cos(YAW[row] / 2)}
    return {"position": {"x": X[row], "y": 1.0, "z": -2.0}, "orientation": turn}


def header(row: int, frame: str = "odom") -> dict[str, Any]:
    """Ten messages a second."""
    return {"stamp": {"sec": row // 10, "nanosec": row % 10 * 10**8}, "frame_id": frame}


def transforms(*frames: tuple[str, str, bool]) -> Callable[[int], dict[str, Any]]:
    """Messages of /tf with these frames: parent, child, whether it moves."""

    def message(row: int) -> dict[str, Any]:
        found = []
        for parent, child, moves in frames:
            there = pose(row if moves else 0)
            tree = {"translation": there["position"], "rotation": there["orientation"]}
            fields = {"header": header(row, parent), "child_frame_id": child, "transform": tree}
            found.append(type_store.build("geometry_msgs/msg/TransformStamped", fields))
        return {"transforms": found}

    return message


def write(folder: Path, topics: dict[str, tuple[str, Callable[[int], dict[str, Any]]]]) -> None:
    """A bag with COUNT messages of each topic."""
    with BagWriter(folder, [Channel(topic, kind) for topic, (kind, _) in topics.items()]) as writer:
        for row in range(COUNT):
            for topic, (kind, content) in topics.items():
                writer.write(
                    topic, row * 10**8, row * 10**8, type_store.serialize(type_store.build(kind, content(row)))
                )


def odometry(row: int) -> dict[str, Any]:
    """A message of Odometry."""
    return {"header": header(row), "child_frame_id": "base_link", "pose": {"pose": pose(row)}}


def stamped(row: int) -> dict[str, Any]:
    """A message of PoseStamped."""
    return {"header": header(row), "pose": pose(row)}


CASES = {
    "odometry of two": (
        {"/one/odom": (ODOMETRY, odometry), "/two/odometry/filtered": (ODOMETRY, odometry)},
        ["one", "two"],
    ),
    "odometry without a namespace": ({"/odom": (ODOMETRY, odometry), "/goal": (POSE, stamped)}, ["robot"]),
    "a pose of another name": ({"/auv/ground_truth": (POSE, stamped)}, ["auv"]),
    "frames": (
        {
            "/tf": (
                TRANSFORMS,
                transforms(("odom", "a/base", True), ("world", "b/base", True), ("world", "still", False)),
            )
        },
        ["a", "b"],
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_tracks(tmp_path: Path, case: str) -> None:
    """The robots, their places and headings, and a sentence on where these are from."""
    topics, robots = CASES[case]
    write(tmp_path / "bag", topics)
    recording = read_recording(tmp_path / "bag")
    assert list(recording.robots) == list(recording.tracks) == robots
    for track in recording.tracks.values():
        assert track.position.tolist() == [[x, 1.0, -2.0] for x in X]
        assert track.yaw == pytest.approx(YAW)
        assert track.stamp_ns.tolist() == [row * 10**8 for row in range(COUNT)]
    assert recording.source_of_poses.startswith("There is no topic NAMESPACE/pose; poses are those of ")


@pytest.mark.parametrize("interval", [None, "0.07 s"])
def test_they_are_measured_in_parts(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, interval: str | None) -> None:
    """Two moments at a time give the numbers of all at once, to the last bit."""
    write(tmp_path / "bag", CASES["odometry of two"][0])
    recording = read_recording(tmp_path / "bag")
    whole = recording.measure(interval)
    monkeypatch.setattr(sampling, "POSES_AT_ONCE", 4)
    parts = recording.measure(interval)
    assert len(whole.stamp_ns) > 4 and parts.tree() == whole.tree()
    assert parts.series.tobytes() == whole.series.tobytes()


def test_the_topics_of_the_contract_come_first(tmp_path: Path) -> None:
    """Where a robot has a topic NAMESPACE/pose, Odometry is not looked at, and nothing is said."""
    write(tmp_path / "bag", {"/one/pose": (POSE, stamped), "/two/odom": (ODOMETRY, odometry)})
    recording = read_recording(tmp_path / "bag")
    assert list(recording.tracks) == ["one"]
    assert recording.source_of_poses == ""


def test_view_and_metrics(cocorosim: Callable[..., SimpleNamespace], tmp_path: Path) -> None:
    """Both commands take such a recording as it is, and say where its poses are from."""
    write(tmp_path / "bag", CASES["odometry of two"][0])
    seen = cocorosim("view", tmp_path / "bag", "--out", tmp_path / "page.html", "--no-open")
    measured = cocorosim("metrics", tmp_path / "bag")
    assert (seen.status, measured.status) == (0, 0)
    for done in (seen, measured):
        assert "one from /one/odom (nav_msgs/msg/Odometry), two from /two/odometry/filtered" in done.out
    assert "polarisation" in measured.out and '"one"' in (tmp_path / "page.html").read_text("utf-8")
