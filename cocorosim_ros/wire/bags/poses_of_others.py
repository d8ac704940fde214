"""Poses in recordings of others, which have no topic NAMESPACE/pose: of Odometry, PoseStamped of any name, or /tf."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.cdr.type_store import deserialize

FIXED_FRAMES = frozenset({"map", "world", "odom", "earth", "tank", "pool", "ned", "enu", "local_origin"})
"""Frames that stand still in the world, by their usual names."""
_ODOMETRY, _POSE = "nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseStamped"
_COVARIANT, TRANSFORMS = "geometry_msgs/msg/PoseWithCovarianceStamped", "tf2_msgs/msg/TFMessage"
_TYPES = (_ODOMETRY, _COVARIANT, _POSE)  # the better one first
_UNNAMED = "robot"


@dataclass(frozen=True)
class PosesOfOthers:
    """The poses of one robot as they come: stamp [ns], then seven numbers, place and quaternion, or None; the frames.

    source: where they are from, for sentences.
    """

    robot: str
    source: str
    rows: tuple[tuple[int, tuple[float, ...] | None], ...]
    frames: tuple[str, ...]


def poses_of_others(bag: Bag) -> list[PosesOfOthers]:
    """The poses of every robot, by its namespace or frame, sorted; of several topics of one the most frequent."""
    topics = {each.topic: each.type_name for each in bag.summary.topics if bag.summary.counts.get(each.topic)}
    for kind in _TYPES:
        chosen = _most_frequent(bag, [topic for topic, type_name in topics.items() if type_name == kind])
        if chosen:
            return [_read(bag, robot, topic, kind) for robot, topic in sorted(chosen.items())]
    transforms = [topic for topic, kind in topics.items() if kind == TRANSFORMS and not topic.endswith("tf_static")]
    return sorted(_moving_frames(bag, transforms), key=lambda each: each.robot)


def _most_frequent(bag: Bag, topics: list[str]) -> dict[str, str]:
    """By robot the topic with the most messages."""
    found: dict[str, str] = {}
    for topic in sorted(topics, key=lambda topic: -bag.summary.counts[topic]):
        namespace = topic.strip("/").rpartition("/")[0].partition("/")[0]
        found.setdefault(namespace or _UNNAMED, topic)
    return found


def _read(bag: Bag, robot: str, topic: str, kind: str) -> PosesOfOthers:
    rows: list[tuple[int, tuple[float, ...] | None]] = []
    frames = set()
    for message in bag.messages([topic]):
        read = _decoded(message.type_name, message.data)
        if read is None:
            rows.append((message.log_time_ns, None))
            continue
        pose = read.pose if kind == _POSE else read.pose.pose
        place, turn = pose.position, pose.orientation
        rows.append((_stamp(read.header), (place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w)))
        frames.add(read.header.frame_id)
    return PosesOfOthers(robot, f"{topic} ({kind})", tuple(rows), tuple(sorted(frames)))


def _moving_frames(bag: Bag, topics: list[str]) -> Iterator[PosesOfOthers]:
    """Frames that move in a frame of the world."""
    rows: dict[tuple[str, str], list[tuple[int, tuple[float, ...]]]] = {}
    for message in bag.messages(topics) if topics else ():
        read = _decoded(message.type_name, message.data)
        for each in () if read is None else read.transforms:
            parent, child = each.header.frame_id.strip("/"), each.child_frame_id.strip("/")
            if is_fixed(parent) and not is_fixed(child):
                place, turn = each.transform.translation, each.transform.rotation
                numbers = (place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w)
                rows.setdefault((parent, child), []).append((_stamp(each.header), numbers))
    for (parent, child), found in rows.items():
        if np.ptp([numbers for _, numbers in found], axis=0).any():
            yield PosesOfOthers(frame_name(child), f"the frame {child} in {parent}", tuple(found), (parent,))


def is_fixed(frame: str) -> bool:
    """Whether a frame stands still in the world, by its name."""
    return frame.rpartition("/")[2] in FIXED_FRAMES


def frame_name(frame: str) -> str:
    """The name of the robot whose frame it is: what stands before the first slash, as ROS takes it."""
    words = re.sub(r"\W", "_", frame.partition("/")[0])
    return words if words[:1].isalpha() else f"{_UNNAMED}_{words}"


def _decoded(type_name: str, data: bytes) -> Any:
    try:
        return deserialize(type_name, data)
    except (CocorosimError, ValueError):
        return None


def _stamp(header: Any) -> int:
    return int(header.stamp.sec) * NANOSECONDS + int(header.stamp.nanosec)
