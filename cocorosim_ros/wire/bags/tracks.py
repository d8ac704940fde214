"""The poses in a recording, robot by robot."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.bags.poses_of_others import poses_of_others
from cocorosim_ros.wire.cdr.stamped_numbers import StampedNumbers, read_stamped_numbers
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic
from cocorosim_ros.world.sensors.pose import yaw_of_quaternions
from cocorosim_ros.world.state.pose_track import PoseTrack

POSE = ROBOT_TOPICS["pose"]
NUMBERS = 7  # x y z of the position, x y z w of the quaternion


@dataclass(frozen=True, repr=False)
class RecordedTrack(PoseTrack):
    """The poses of one robot by their header stamps, each stamp once, and what was left out.

    The yaw is in [-pi, pi], NaN where the quaternion is zero.
    """

    frames: tuple[str, ...]  # frame_ids of the messages; ("world",) by the contract
    duplicates: int  # dropped: same stamp, same pose
    conflicts: int  # dropped: same stamp, another pose than the first one recorded
    not_finite: int  # dropped: a NaN or infinity in the pose
    unreadable: int  # dropped: not a PoseStamped

    @property
    def time(self) -> Floats:
        """(n,) [s] since the first pose of this robot."""
        return read_only(np.asarray((self.stamp_ns - self.stamp_ns[:1]) * 1e-9, dtype=np.float64))


def read_poses(bag: Bag | Path | str) -> dict[str, RecordedTrack]:
    """The track of every robot of a recording, by its namespace (lily_01, tank/lily_01), sorted.

    Robots are the topics NAMESPACE/pose of type geometry_msgs/PoseStamped, at any depth of namespace; without any,
    those that `read_poses_and_source` tells.
    """
    return read_poses_and_source(bag)[0]


def read_poses_and_source(bag: Bag | Path | str) -> tuple[dict[str, RecordedTrack], str]:
    """The tracks, and a sentence on where they are from if there is no topic NAMESPACE/pose.

    Then the robots are the topics of type nav_msgs/Odometry by their first namespace, else those with poses under other
    names, else the frames that move in a frame of the world in /tf.
    """
    opened = bag if isinstance(bag, Bag) else read_bag(bag)
    topics = [topic.topic for topic in opened.summary.topics if is_pose(topic.topic, topic.type_name)]
    recorded: dict[str, list[bytes]] = {topic: [] for topic in topics}
    for message in opened.messages(topics):
        if message.type_name == POSE.type_name:
            recorded[message.topic].append(message.data)
    if not topics:
        return _tracks_of_others(opened)
    return {split_topic(topic)[0]: pose_track(recorded[topic]) for topic in sorted(topics)}, ""


def _tracks_of_others(bag: Bag) -> tuple[dict[str, RecordedTrack], str]:
    found = poses_of_others(bag)
    tracks = {}
    for each in found:
        stamps = np.array([stamp for stamp, _ in each.rows], dtype=np.int64)
        numbers = np.array([row or (np.nan,) * NUMBERS for _, row in each.rows], dtype=np.float64)
        readable = np.array([row is not None for _, row in each.rows], dtype=np.bool_)
        tracks[each.robot] = _track(StampedNumbers(stamps, numbers, readable, each.frames))
    told = ", ".join(f"{each.robot} from {each.source}" for each in found)
    return tracks, f"There is no topic NAMESPACE/pose; poses are those of {told}." if found else ""


def is_pose(topic: str, type_name: str) -> bool:
    """Whether a topic holds the poses of a robot."""
    return type_name == POSE.type_name and split_topic(topic)[1] == POSE.name


def pose_track(messages: Sequence[bytes]) -> RecordedTrack:
    """The track in the CDR bytes of PoseStamped messages, in recorded order."""
    return _track(read_stamped_numbers(messages, NUMBERS))


def _track(read: StampedNumbers) -> RecordedTrack:
    """The track of place and quaternion in each row."""
    stamps, numbers, readable = read.stamp_ns, read.numbers, read.readable
    finite = readable & np.isfinite(numbers).all(axis=1)
    kept, duplicates, conflicts = first_of_each_stamp(stamps, numbers, np.flatnonzero(finite))
    return RecordedTrack(
        stamps[kept],
        numbers[kept, :3],
        yaw_of_quaternions(numbers[kept, 3:]),
        read.frames,
        duplicates,
        conflicts,
        int(np.count_nonzero(readable & ~finite)),
        int(np.count_nonzero(~readable)),
    )


def first_of_each_stamp(stamps: Integers, numbers: Floats, rows: NDArray[np.intp]) -> tuple[NDArray[np.intp], int, int]:
    """Rows of the first recorded of each stamp, sorted; how many equal and unequal ones were dropped."""
    rows = rows[np.argsort(stamps[rows], kind="stable")]
    first = np.ones(len(rows), dtype=bool)
    first[1:] = stamps[rows[1:]] != stamps[rows[:-1]]
    leader = rows[first][np.cumsum(first) - 1] if len(rows) else rows
    same = (numbers[rows] == numbers[leader]).all(axis=1)
    return rows[first], int(np.count_nonzero(same & ~first)), int(np.count_nonzero(~same))


def decode_poses(messages: Sequence[bytes]) -> tuple[Floats, Floats]:
    """Position (n, 3) [m; world] and yaw (n,) [rad] of n PoseStamped messages in their order; NaN where unreadable."""
    numbers = read_stamped_numbers(messages, NUMBERS).numbers
    return numbers[:, :3], yaw_of_quaternions(numbers[:, 3:])
