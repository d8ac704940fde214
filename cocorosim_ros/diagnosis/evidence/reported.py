"""Logs with what their actuators report, on the clock of the commands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.clocks import are_of_one_clock
from cocorosim_ros.diagnosis.evidence.feedback_rows import read_feedback_rows
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.topic_rows import TopicRows
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.topics.actuator_feedback import FEEDBACK
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic

_TYPE = ROBOT_TOPICS[FEEDBACK].type_name


@dataclass
class _Messages:
    """The messages of one topic as they were recorded, with their log times [ns]."""

    data: list[bytes] = field(default_factory=list)
    log_ns: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class Commanded:
    """The commands of robots, by name, as they were recorded; the actuators that they may name; the start [ns]."""

    rows: Mapping[str, TopicRows]
    actuators: tuple[str, ...]
    start_ns: int


def with_reports(logs: Sequence[RobotLog], bag: Bag, commanded: Commanded) -> tuple[list[RobotLog], list[str]]:
    """Give logs what their actuators report, and sentences about what is not used.

    Logs without any report stay as they are. Raises CocorosimError if a robot's reports name none of the actuators.
    """
    remarks: list[str] = []
    reports = {split_topic(topic)[0]: topic for topic in _wanted(bag, remarks)}
    found = {reports[log.name]: _Messages() for log in logs if log.name in reports}
    for message in bag.messages(found) if found else ():
        if message.type_name == _TYPE:
            found[message.topic].data.append(message.data)
            found[message.topic].log_ns.append(message.log_time_ns)
    full = [
        _with_reports(log, reports[log.name], found[reports[log.name]], commanded, remarks)
        if log.name in reports and log.name in commanded.rows
        else log
        for log in logs
    ]
    return full, remarks


def _wanted(bag: Bag, remarks: list[str]) -> Iterator[str]:
    """The topics of what actuators report; a remark for each that has the right name but the wrong type."""
    for recorded in bag.summary.topics:
        if split_topic(recorded.topic)[1] != FEEDBACK:
            continue
        if recorded.type_name == _TYPE:
            yield recorded.topic
        else:
            remarks.append(
                f"{recorded.topic} is of type {recorded.type_name} instead of {_TYPE} and is not used; `cocorosim "
                "convert` can bring it into that type."
            )


def _with_reports(log: RobotLog, topic: str, messages: _Messages, commanded: Commanded, remarks: list[str]) -> RobotLog:
    """Give a log its reports, as far as they are on the clock of its commands."""
    read = read_feedback_rows(topic, messages.data, commanded.actuators, commanded.start_ns)
    remarks += read.remarks
    log_ns = np.array(messages.log_ns, dtype=np.int64)[read.readable]
    rows = TopicRows(log.name, FEEDBACK, read.stamp_ns, log_ns, np.empty((len(log_ns), 0)))
    if not read.series:
        return log
    if not are_of_one_clock(rows, commanded.rows[log.name]):
        remarks.append(
            f"{topic}: its stamps are of another clock than those of the commands, by the log times; by when actuators "
            "follow cannot be told from them, and they are not used."
        )
        return log
    later = log.command_shifted
    return replace(log, feedback=tuple(replace(each, time=each.time + later) for each in read.series))
