"""The messages of each robot's topics as rows of numbers, in recorded order, as they are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.evidence.command_rows import read_command_rows
from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.bags.tracks import yaw_of_quaternions
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps, read_stamped_numbers
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic

COMMAND = "thruster_command"
NOT_ESTIMATED = -1.0  # REP 145: first element of the covariance of what an IMU does not measure


@dataclass(frozen=True)
class TopicRows:
    """n messages of one topic of one robot: header stamps and log times (n,) [ns], values (n, columns).

    columns are those of STREAMS, or the platform's actuators. remarks: what was left out, in sentences.
    """

    robot: str
    topic: str
    stamp_ns: Stamps
    log_ns: Stamps
    values: Floats
    remarks: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The topic as sentences call it: lily_01/pose."""
        return f"{self.robot}/{self.topic}" if self.robot else self.topic


class _Found(NamedTuple):
    data: list[bytes]
    log_ns: list[int]


def _pose_columns(numbers: Floats) -> Floats:
    return np.column_stack([numbers[:, :3], yaw_of_quaternions(numbers[:, 3:])])


def _imu_columns(numbers: Floats) -> Floats:
    """After orientation (4), its covariance (9), rate (3), its covariance (9), specific force (3), its covariance."""
    rate, force = numbers[:, 15:16].copy(), numbers[:, 25:28].copy()
    rate[numbers[:, 16] == NOT_ESTIMATED] = np.nan
    force[(numbers[:, 28] == NOT_ESTIMATED) | (force == 0.0).all(axis=1)] = np.nan
    return np.hstack([rate, force])


_NUMBERS: dict[str, tuple[int, Callable[[Floats], Floats]]] = {  # how many a message has, and the columns from them
    "pose": (7, _pose_columns),
    "compass": (2, lambda numbers: numbers[:, :1]),
    "pressure": (2, lambda numbers: numbers[:, :1]),
    "imu": (37, _imu_columns),
    "velocity": (6, lambda numbers: numbers[:, :3]),
}


def read_topic_rows(bag: Bag, actuators: tuple[str, ...]) -> tuple[list[TopicRows], list[str]]:
    """The rows of every topic of every robot that the diagnosis can use, and what was noticed besides.

    A robot whose commands name none of the actuators is of another kind: it is left out, and said. Raises
    CocorosimError if all are.
    """
    wanted, remarks = _wanted(bag)
    found = {topic: _Found([], []) for topic in wanted}
    for message in bag.messages(wanted):
        place = found[message.topic]
        if message.type_name == ROBOT_TOPICS[split_topic(message.topic)[1]].type_name:
            place.data.append(message.data)
            place.log_ns.append(message.log_time_ns)
    topics: list[TopicRows] = []
    strangers: dict[str, CocorosimError] = {}
    for topic in wanted:
        if found[topic].data:
            try:
                topics.append(_rows(topic, found[topic], actuators))
            except CocorosimError as error:
                strangers[split_topic(topic)[0]] = error
    if strangers and not any(rows.topic == COMMAND for rows in topics):
        raise next(iter(strangers.values()))
    remarks += [f"{robot} was left out: {error}" for robot, error in strangers.items()]
    return [rows for rows in topics if rows.robot not in strangers], remarks


def _wanted(bag: Bag) -> tuple[list[str], list[str]]:
    """The topics to be read, and a sentence for each that has the name but not the type."""
    wanted, remarks = [], []
    for recorded in bag.summary.topics:
        name = split_topic(recorded.topic)[1]
        if name not in STREAMS and name != COMMAND:
            continue
        right = ROBOT_TOPICS[name].type_name
        if recorded.type_name == right:
            wanted.append(recorded.topic)
        else:
            remarks.append(
                f"{recorded.topic} is of type {recorded.type_name} instead of {right} and is not used; "
                "`cocorosim convert` can bring it into that type."
            )
    return wanted, remarks


def _rows(topic: str, found: _Found, actuators: tuple[str, ...]) -> TopicRows:
    robot, name = split_topic(topic)
    log_ns = np.array(found.log_ns, dtype=np.int64)
    if name == COMMAND:
        commands = read_command_rows(topic, found.data, actuators)
        readable, stamps, values, remarks = commands.readable, commands.stamp_ns, commands.values, commands.remarks
    else:
        count, columns = _NUMBERS[name]
        read = read_stamped_numbers(found.data, count)
        readable, stamps, values, remarks = read.readable, read.stamp_ns, columns(read.numbers), ()
    remarks = (*remarks, *_unreadable(topic, readable))
    return TopicRows(robot, name, stamps[readable], log_ns[readable], values[readable], remarks)


def _unreadable(topic: str, readable: Flags) -> Sequence[str]:
    bad = np.count_nonzero(~readable)
    return [f"{topic}: {bad} of {len(readable)} messages could not be read and were left out."] if bad else []
