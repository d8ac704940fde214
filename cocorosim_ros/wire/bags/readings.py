"""What a recording's robots measured and what was asked of their actuators, topic by topic, as rows of numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.card import Card, Shown, digits
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.cdr.stamped_numbers import numbers_of, read_stamped_numbers
from cocorosim_ros.wire.cdr.type_store import deserialize
from cocorosim_ros.wire.topics.actuator_feedback import FEEDBACK, QUANTITIES
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.pose import POSE
from cocorosim_ros.world.sensors.sensor import Column, Elements

if TYPE_CHECKING:
    import pandas as pd

Named = dict[str, float]


@dataclass(frozen=True, repr=False)
class TopicReadings(Shown):
    """n messages of one topic of one robot, in recorded order, as they were recorded: nothing is sorted or repaired."""

    robot: str
    topic: str
    stamp_ns: Integers
    """(n,) moment of each measurement by its header [ns]."""
    columns: tuple[str, ...]
    units: tuple[str, ...]
    """Of each column; "1" for none."""
    values: Floats
    """(n, columns), NaN where a message does not have the column."""
    unreadable: int
    """How many messages were left out because their bytes are not of the topic's type."""

    @property
    def time(self) -> Floats:
        """(n,) [s] by the header stamps, from the same zero for all topics of a recording."""
        return read_only(np.asarray(self.stamp_ns / NANOSECONDS))

    def column(self, name: str) -> Floats:
        """(n,) the values of one column, in its unit. Raises CocorosimError if there is none of that name."""
        if name not in self.columns:
            known = ", ".join(self.columns) or "none"
            raise CocorosimError(f"{self.robot}/{self.topic} has no column '{name}'; its columns are: {known}.")
        return np.asarray(self.values[:, self.columns.index(name)])

    def to_frame(self) -> pd.DataFrame:
        """One row a message: stamp_ns [ns], time [s], then its columns in their units."""
        return data_frame(
            {"stamp_ns": self.stamp_ns, "time": self.time, **{name: self.column(name) for name in self.columns}}
        )

    def card(self) -> Card:
        """How many messages there are, and between what each column lies."""
        rows = [(name, unit, *_reach(self.column(name))) for name, unit in zip(self.columns, self.units, strict=True)]
        facts = {"messages": str(len(self.stamp_ns)), "unreadable": str(self.unreadable)}
        return Card(f"{self.topic} of {self.robot}", facts, ("column", "unit", "least", "most"), rows)


def _reach(values: Floats) -> tuple[str, str]:
    """The least and the most of what is known, as text."""
    known = values[~np.isnan(values)]
    return (digits(float(known.min())), digits(float(known.max()))) if known.size else (digits(None), digits(None))


@dataclass(frozen=True)
class _Rows:
    """One row for each of n messages, those that could not be read included."""

    stamp_ns: Integers
    """(n,) [ns] by the header."""
    values: Floats
    """(n, columns)."""
    readable: Flags
    """(n,) which could be read."""


def _commands(message: Any) -> Named:
    return dict(zip(message.name, message.command.tolist(), strict=True))


def _feedback(message: Any) -> Named:
    return dict(zip(message.name, message.value.tolist(), strict=True))


READABLE: dict[str, tuple[Column, ...] | Elements] = {
    **{topic: sensor.shown for topic, sensor in SENSORS.items() if sensor is not POSE},
    "thruster_command": Elements(_commands, "1"),
    FEEDBACK: Elements(_feedback, "1", {name: quantity.unit for name, quantity in QUANTITIES.items()}),
}
"""The topics that are numbers, by name, but for poses, which are tracks (`bags.tracks`)."""


def read_readings(bag: Bag) -> tuple[dict[str, dict[str, TopicReadings]], list[str]]:
    """The readings of every robot by namespace (lily_01, tank/lily_01), sorted, then by topic; what is not read.

    The sentences name topics that have another type than the contract's, and messages that could not be read.
    """
    wanted, findings = readable_topics(bag)
    messages: dict[str, list[bytes]] = {topic: [] for topic in wanted}
    for message in bag.messages(wanted):
        if message.type_name == ROBOT_TOPICS[split_topic(message.topic)[1]].type_name:
            messages[message.topic].append(message.data)
    found: dict[str, dict[str, TopicReadings]] = {}
    for topic in sorted(wanted):
        robot, name = split_topic(topic)
        readings = topic_readings(robot, name, messages[topic])
        found.setdefault(robot, {})[name] = readings
        if readings.unreadable:
            findings.append(f"{topic}: {readings.unreadable} of {len(messages[topic])} messages could not be read.")
    return found, findings


def topic_readings(robot: str, topic: str, messages: Sequence[bytes]) -> TopicReadings:
    """The readings in the CDR bytes of the messages of one topic, a name in READABLE."""
    shown = READABLE[topic]
    if not isinstance(shown, Elements):
        paths = numbers_of(ROBOT_TOPICS[topic].type_name)
        read = read_stamped_numbers(messages, len(paths))
        values = read.numbers[:, [paths.index(column.place) for column in shown]]
        names, units = tuple(column.name for column in shown), tuple(column.unit for column in shown)
        return _kept(robot, topic, _Rows(read.stamp_ns, values, read.readable), names, units)
    stamps, named, readable = _named_rows(topic, messages, shown)
    columns = tuple(dict.fromkeys(name for row in named for name in row))
    values = np.array([[row.get(name, np.nan) for name in columns] for row in named]).reshape(len(named), len(columns))
    return _kept(robot, topic, _Rows(stamps, values, readable), columns, tuple(map(shown.unit_of, columns)))


def readable_topics(bag: Bag) -> tuple[list[str], list[str]]:
    """The topics that are read; a sentence for each that has the name but not the type of one, or an unknown layout."""
    wanted, findings = [], []
    for recorded in bag.summary.topics:
        name = split_topic(recorded.topic)[1]
        if name not in READABLE:
            continue
        right = ROBOT_TOPICS[name].type_name
        if recorded.type_name != right:
            findings.append(f"{recorded.topic} is of type {recorded.type_name} instead of {right} and is not read.")
        elif isinstance(READABLE[name], Elements) or numbers_of(right):
            wanted.append(recorded.topic)
        else:
            findings.append(
                f"{recorded.topic} is left out: {right} is more than numbers, and no file says how it is read."
            )
    return wanted, findings


def _named_rows(topic: str, messages: Sequence[bytes], elements: Elements) -> tuple[Integers, list[Named], Flags]:
    """(n,) stamps [ns], the elements of each message by name, and (n,) which messages could be read."""
    stamps, readable = np.zeros(len(messages), np.int64), np.ones(len(messages), np.bool_)
    rows: list[Named] = []
    for index, data in enumerate(messages):
        try:
            message = deserialize(ROBOT_TOPICS[topic].type_name, data)
            rows.append(elements.read(message))
            stamps[index] = message.header.stamp.sec * NANOSECONDS + message.header.stamp.nanosec
        except (CocorosimError, ValueError):
            readable[index] = False
            rows.append({})
    return stamps, rows, readable


def _kept(robot: str, topic: str, rows: _Rows, columns: tuple[str, ...], units: tuple[str, ...]) -> TopicReadings:
    """The readings of the messages that could be read."""
    kept = rows.readable
    unreadable = int(np.count_nonzero(~kept))
    return TopicReadings(robot, topic, rows.stamp_ns[kept], columns, units, rows.values[kept], unreadable)
