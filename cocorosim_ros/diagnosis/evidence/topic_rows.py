"""Messages of each robot's topics as rows of numbers, unchanged and in recorded order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.evidence.command_rows import read_command_rows
from cocorosim_ros.diagnosis.evidence.streams.attitude import tilt_of
from cocorosim_ros.diagnosis.evidence.streams.log import STREAMS
from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.cdr.stamped_numbers import Stamps, read_stamped_numbers
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic
from cocorosim_ros.world.sensors import SENSORS

COMMAND = "thruster_command"
NO_ATTITUDE = np.empty((0, 2))
_RECORDED = {topic: sensor.recorded for topic, sensor in SENSORS.items() if sensor.recorded is not None}


@dataclass(frozen=True)
class TopicRows:
    """Contents of n messages of one topic of one robot: header stamps and log times (n,) [ns], values (n, columns).

    The columns are those of STREAMS, or the platform's actuators. remarks: a sentence for all that was left out.
    shifted: by how much most of the stamps were set later to be on one clock [s].
    commanded: actuators that commands name, whether the platform has them or not.
    """

    robot: str
    topic: str
    stamp_ns: Stamps
    log_ns: Stamps
    values: Floats
    attitude: Floats = field(
        default_factory=lambda: NO_ATTITUDE
    )  # (n, 2) roll and pitch [rad], where the topic tells them
    remarks: tuple[str, ...] = ()
    shifted: float = 0.0
    commanded: tuple[str, ...] = ()

    def chosen(self, rows: Integers | Flags) -> TopicRows:
        """The rows with these numbers, or where these flags (n,) are true, in that order."""
        attitude = self.attitude[rows] if len(self.attitude) else self.attitude
        return replace(
            self,
            stamp_ns=self.stamp_ns[rows],
            log_ns=self.log_ns[rows],
            values=self.values[rows],
            attitude=attitude,
        )

    @property
    def name(self) -> str:
        """The name of the topic in sentences: lily_01/pose."""
        return f"{self.robot}/{self.topic}" if self.robot else self.topic


class _Found(NamedTuple):
    data: list[bytes]
    log_ns: list[int]


def read_topic_rows(bag: Bag, platform: Platform) -> tuple[list[TopicRows], list[str]]:
    """Read the rows of every topic that the diagnosis can use, of every robot; also give remarks, as sentences.

    A robot whose commands name none of the actuators is of another kind: it is left out, with a remark. Raises
    CocorosimError if all robots are of another kind.
    """
    wanted, remarks = _wanted(bag)
    found = {topic: _Found([], []) for topic in wanted}
    for message in bag.messages(wanted):
        place = found[message.topic]
        if message.type_name == ROBOT_TOPICS[split_topic(message.topic)[1]].type_name:
            place.data.append(message.data)
            place.log_ns.append(message.log_time_ns)
    topics: list[TopicRows] = []
    unusable: dict[str, CocorosimError] = {}
    for topic in wanted:
        if found[topic].data:
            try:
                topics.append(_rows(topic, found[topic], platform))
            except CocorosimError as error:
                unusable[split_topic(topic)[0]] = error
    if unusable and not any(rows.topic == COMMAND for rows in topics):
        raise next(iter(unusable.values()))
    remarks += [f"{robot} was left out: {error}" for robot, error in unusable.items()]
    return [rows for rows in topics if rows.robot not in unusable], remarks


def _wanted(bag: Bag) -> tuple[list[str], list[str]]:
    """The topics to be read, and a sentence for each topic that has the right name but the wrong type."""
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


def _rows(topic: str, found: _Found, platform: Platform) -> TopicRows:
    robot, name = split_topic(topic)
    log_ns = np.array(found.log_ns, dtype=np.int64)
    attitude, said = NO_ATTITUDE, ""
    commanded: tuple[str, ...] = ()
    if name == COMMAND:
        commands = read_command_rows(topic, found.data, platform.of_robot(robot))
        readable, stamps, values, remarks = commands.readable, commands.stamp_ns, commands.values, commands.remarks
        commanded = commands.commanded
    else:
        recorded = _RECORDED[name]
        read = read_stamped_numbers(found.data, recorded.numbers)
        readable, stamps, values, remarks = read.readable, read.stamp_ns, recorded.columns(read.numbers), ()
        if recorded.orientation is not None:
            attitude, said = tilt_of(topic, recorded.orientation(read.numbers))
    remarks = (*remarks, *unreadable(topic, readable), *([said] if said else []))
    rows = TopicRows(robot, name, stamps, log_ns, values, attitude, remarks, commanded=commanded)
    return rows.chosen(readable)


def unreadable(topic: str, readable: Flags) -> Sequence[str]:
    """Say how many messages of a topic could not be read: a sentence, none if all could; readable (n,)."""
    bad = np.count_nonzero(~readable)
    return [f"{topic}: {bad} of {len(readable)} messages could not be read and were left out."] if bad else []
