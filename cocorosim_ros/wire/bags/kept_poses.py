"""The poses of a recording that may have lasted for days: their stamps in memory, places and headings in a file."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.kept_rows import KeptRows
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.bags.tracks import NUMBERS, POSE, is_pose
from cocorosim_ros.wire.cdr.stamped_numbers import read_stamped_numbers
from cocorosim_ros.wire.topics.topics import split_topic
from cocorosim_ros.world.sensors.pose import yaw_of_quaternions

MESSAGES_AT_ONCE = 16_384  # of all robots, decoded together
_ROW = np.dtype([("stamp_ns", np.int64), ("position", np.float64, (3,)), ("yaw", np.float64)])


@dataclass(frozen=True, eq=False)
class KeptTrack:
    """The poses of one robot as `RecordedTrack` has them, each stamp once, sorted; looked up when they are asked for.

    The yaw is in [-pi, pi], NaN where the quaternion is zero.
    """

    stamp_ns: Integers
    """(t,) moment of each pose [ns]."""
    chosen: Integers | None
    """(t,) which of the robot's poses in the order of recording they are; None: all of them, as recorded."""
    pieces: Integers
    """(p, 2) rows of the file that hold the robot's poses in the order of recording: first one, and how many."""
    rows: KeptRows
    """The poses of all robots."""

    def at(self, rows: Integers) -> tuple[Floats, Floats]:
        """Position (n, 3) [m; world] and yaw (n,) [rad; world] of the poses `rows` (n,)."""
        recorded = rows if self.chosen is None else self.chosen[rows]
        begins = np.cumsum(self.pieces[:, 1]) - self.pieces[:, 1]
        piece = np.searchsorted(begins, recorded, side="right") - 1
        found = self.rows.at(self.pieces[piece, 0] + recorded - begins[piece])
        return found["position"].copy(), found["yaw"].copy()


@dataclass
class _Gathered:
    """What was found of one robot so far."""

    stamps: list[Integers] = field(default_factory=lambda: [np.empty(0, np.int64)])
    pieces: list[tuple[int, int]] = field(default_factory=list)

    def track(self, rows: KeptRows) -> KeptTrack:
        """Of several poses with one stamp the first stays."""
        stamps, pieces = np.concatenate(self.stamps), np.array(self.pieces, np.int64).reshape(-1, 2)
        if (np.diff(stamps) > 0).all():
            return KeptTrack(read_only(stamps), None, read_only(pieces), rows)
        unique, first = np.unique(stamps, return_index=True)
        return KeptTrack(read_only(unique), read_only(first), read_only(pieces), rows)


def keep_poses(bag: Bag) -> dict[str, KeptTrack]:
    """The tracks that `read_poses` gives of the topics NAMESPACE/pose, by namespace, in memory that hardly grows."""
    topics = sorted(topic.topic for topic in bag.summary.topics if is_pose(topic.topic, topic.type_name))
    number = {topic: place for place, topic in enumerate(topics)}
    rows, gathered = KeptRows((), _ROW), [_Gathered() for _ in topics]
    robots: list[int] = []
    messages: list[bytes] = []
    for message in bag.messages(topics):
        if message.type_name == POSE.type_name:
            robots.append(number[message.topic])
            messages.append(message.data)
        if len(messages) == MESSAGES_AT_ONCE:
            _keep(robots, messages, rows, gathered)
            robots, messages = [], []
    _keep(robots, messages, rows, gathered)
    return {split_topic(topic)[0]: each.track(rows) for topic, each in zip(topics, gathered, strict=True)}


def _keep(robots: list[int], messages: list[bytes], rows: KeptRows, gathered: list[_Gathered]) -> None:
    """The messages' poses come behind `rows`, robot after robot; those that are no numbers are left out."""
    read = read_stamped_numbers(messages, NUMBERS)
    usable = np.flatnonzero(read.readable & np.isfinite(read.numbers).all(axis=1))
    owners = np.array(robots, np.int64)[usable]
    order = np.argsort(owners, kind="stable")
    numbers = read.numbers[usable[order]]
    table = np.empty(len(order), _ROW)
    table["stamp_ns"] = read.stamp_ns[usable[order]]
    table["position"], table["yaw"] = numbers[:, :3], yaw_of_quaternions(numbers[:, 3:])
    bounds = np.searchsorted(owners[order], np.arange(len(gathered) + 1)).tolist()
    for robot, (begin, end) in enumerate(pairwise(bounds)):
        if begin < end:
            gathered[robot].pieces.append((rows.count + begin, end - begin))
            gathered[robot].stamps.append(table["stamp_ns"][begin:end].copy())
    rows.add(table)
