"""The poses of a recording that may have lasted for days: in a file, and in memory their stamps.

Robots of a simulation share their stamps, and so do their tracks here.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

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


class _Piece(NamedTuple):
    """Rows that hold successive poses of one robot."""

    first: int
    length: int


@dataclass(frozen=True, eq=False)
class KeptTrack:
    """The poses of one robot as `RecordedTrack` has them, each stamp once, sorted; looked up when they are asked for.

    The yaw is in [-pi, pi], NaN where the quaternion is zero.
    """

    stamp_ns: Integers
    """(t,) moment of each pose [ns]; one array with other robots that have the same."""
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


def keep_poses(bag: Bag) -> dict[str, KeptTrack]:
    """The tracks that `read_poses` gives of the topics NAMESPACE/pose, by namespace, in memory that hardly grows."""
    topics = sorted(topic.topic for topic in bag.summary.topics if is_pose(topic.topic, topic.type_name))
    number = {topic: place for place, topic in enumerate(topics)}
    rows = KeptRows((), _ROW)
    pieces: list[list[_Piece]] = [[] for _ in topics]
    robots: list[int] = []
    messages: list[bytes] = []
    for message in bag.messages(topics):
        if message.type_name == POSE.type_name:
            robots.append(number[message.topic])
            messages.append(message.data)
        if len(messages) == MESSAGES_AT_ONCE:
            _keep(robots, messages, rows, pieces)
            robots, messages = [], []
    _keep(robots, messages, rows, pieces)
    tracks: dict[str, KeptTrack] = {}
    latest: KeptTrack | None = None
    for topic, found in zip(topics, pieces, strict=True):
        latest = tracks[split_topic(topic)[0]] = _track(rows, found, latest)
    return tracks


def _track(rows: KeptRows, found: list[_Piece], other: KeptTrack | None) -> KeptTrack:
    """The track of the poses in these pieces of `rows`, with the stamps of another one if they are the same.

    Of several poses with one stamp the first stays.
    """
    pieces, stamps = read_only(np.array(found, np.int64).reshape(-1, 2)), _stamps(rows, found)
    if not (np.diff(stamps) > 0).all():
        unique, first = np.unique(stamps, return_index=True)
        return KeptTrack(read_only(unique), read_only(first), pieces, rows)
    if other is not None and np.array_equal(stamps, other.stamp_ns):
        return KeptTrack(other.stamp_ns, None, pieces, rows)
    return KeptTrack(read_only(stamps), None, pieces, rows)


def _stamps(rows: KeptRows, pieces: list[_Piece]) -> Integers:
    """(t,) stamps of the poses in these pieces, in the order of recording [ns]."""
    stamps = np.empty(sum(piece.length for piece in pieces), np.int64)
    begin = 0
    for first, length in pieces:
        stamps[begin : begin + length] = rows.at(np.arange(first, first + length))["stamp_ns"]
        begin += length
    return stamps


def _keep(robots: list[int], messages: list[bytes], rows: KeptRows, pieces: list[list[_Piece]]) -> None:
    """The messages' poses come behind `rows`, robot after robot; those that are no numbers are left out."""
    read = read_stamped_numbers(messages, NUMBERS)
    usable = np.flatnonzero(read.readable & np.isfinite(read.numbers).all(axis=1))
    owners = np.array(robots, np.int64)[usable]
    order = np.argsort(owners, kind="stable")
    numbers = read.numbers[usable[order]]
    table = np.empty(len(order), _ROW)
    table["stamp_ns"] = read.stamp_ns[usable[order]]
    table["position"], table["yaw"] = numbers[:, :3], yaw_of_quaternions(numbers[:, 3:])
    bounds = np.searchsorted(owners[order], np.arange(len(pieces) + 1)).tolist()
    for robot, (begin, end) in enumerate(pairwise(bounds)):
        if begin < end:
            pieces[robot].append(_Piece(rows.count + begin, end - begin))
    rows.add(table)
