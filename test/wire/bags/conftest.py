"""Small recordings for the tests of this folder."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build

POSE = "geometry_msgs/msg/PoseStamped"
FIELDS = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
Row = tuple[str, int, int, bytes]  # topic, log time, publish time, data


def make_rows(ticks: int, robots: int = 2) -> list[Row]:
    """Poses of some robots, every 0.5 s, received 1 ms after they were published."""
    rng = np.random.default_rng(1)
    packed = PackedMessage([build(POSE, {"header": {"frame_id": "world"}})] * robots, FIELDS)
    rows: list[Row] = []
    for tick in range(ticks):
        stamp = tick * 500_000_000
        for robot, data in enumerate(packed.encode(stamp, rng.normal(size=(robots, 7)))):
            rows.append((f"/lily_{robot + 1:02d}/pose", stamp + 1_000_000, stamp, data))
    return rows


def write_rows(folder: Path, rows: Sequence[Row], **options: Any) -> str:
    """Record the rows; the digest."""
    with BagWriter(folder, [Channel(topic, POSE) for topic in sorted({row[0] for row in rows})], **options) as bag:
        for row in rows:
            bag.write(*row)
    return bag.digest.hexdigest()


@pytest.fixture
def pose_rows() -> Callable[..., list[Row]]:
    """A function from a number of ticks (and robots) to messages."""
    return make_rows


@pytest.fixture
def record() -> Callable[..., str]:
    """A function that records messages into a folder and returns the digest."""
    return write_rows
