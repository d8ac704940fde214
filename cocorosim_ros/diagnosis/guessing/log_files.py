"""Bags of ROS and ULogs as tables: a table a topic, with what lists of numbers hold."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.checking.topic_log import TopicLog, Transform, read_topics
from cocorosim_ros.diagnosis.criteria.guessing import GUESSING
from cocorosim_ros.diagnosis.guessing.log_table import LogTable
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.bags.poses_of_others import TRANSFORMS, is_fixed
from cocorosim_ros.wire.conversion.bag_rows import BagRows
from cocorosim_ros.wire.conversion.formats.bag import open_messages
from cocorosim_ros.wire.conversion.formats.message_log import MessageLog
from cocorosim_ros.wire.conversion.formats.ulog import ULogLog


def tables_of_bag(path: Path) -> Iterator[LogTable]:
    """Every topic of a bag of ROS 1 or 2 whose messages hold numbers."""
    log = open_messages(path)
    for topic in read_topics(log):
        columns = {name: topic.number(name) for name in topic.columns}
        if topic.type_name == TRANSFORMS:
            yield from _moving_transforms(topic)
        else:
            listed = dict(_listed(log, topic))
            if columns or listed:
                where = {"topic": topic.name}
                yield LogTable(topic.name, topic.type_name, topic.time(), {**columns, **listed}, where)


def tables_of_ulog(path: Path) -> Iterator[LogTable]:
    """Every topic of a ULog."""
    log = ULogLog(path)
    for topic in log.topics:
        rows = log.rows(topic, Entry(topic, "", 0, "topic"))
        columns = {name: rows.numbers(Entry(name, "", 0, "")) for name in rows.columns}
        time = columns.pop("timestamp") / 1e6
        yield LogTable(topic, "px4", time - time[0], columns, {"topic": topic})


def _listed(log: MessageLog, topic: TopicLog) -> Iterator[tuple[str, Floats]]:
    """The elements of short lists of numbers, such as `channels[0]` or `velocity[left]`."""
    if not topic.values.size and not len(topic.columns) == 0:
        return
    first = _first_message(log, topic)
    paths = [path for path in _list_paths(first) if "covariance" not in path]
    if not paths:
        return
    rows = BagRows(log, topic.name, Entry(topic.name, "", 0, "topic"))
    for path in paths:
        yield path, rows.numbers(Entry(path, "", 0, "column"))


def _first_message(log: MessageLog, topic: TopicLog) -> Any:
    recorded = next(each for each in log.topics if each.topic == topic.name)
    try:
        decode = log.decoder(recorded)
        return decode(next(iter(log.messages(topic.name)))[1])
    except (CocorosimError, ValueError, IndexError):
        return None


def _list_paths(message: Any) -> list[str]:
    if message is None or not hasattr(message, "__dict__"):
        return []
    names = getattr(message, "name", None)
    found: list[str] = []
    for field, value in vars(message).items():
        numbers = isinstance(value, np.ndarray) and value.dtype.kind in "iuf" and value.ndim == 1
        if numbers and 0 < len(value) <= GUESSING.most_listed:
            named = names if isinstance(names, list) and len(names) == len(value) else range(len(value))
            found += [f"{field}[{name}]" for name in named]
    return found


def _moving_transforms(topic: TopicLog) -> Iterator[LogTable]:
    """One table for each frame that moves in a frame of the world."""
    found: dict[tuple[str, str], list[Transform]] = {}
    for transform in topic.transforms:
        if is_fixed(transform.parent) and not is_fixed(transform.child):
            found.setdefault((transform.parent, transform.child), []).append(transform)
    for (_, child), transforms in found.items():
        numbers = np.array([each.numbers for each in transforms])
        if len(transforms) < 2 or not np.ptp(numbers, axis=0).any():
            continue
        at = f"transforms[{child}]"
        yield LogTable(topic.name, f"{TRANSFORMS} of {child}", _seconds(transforms), _of_transform(at, numbers), {
            "topic": topic.name, "time": {"stamp": f"{at}.header.stamp"},
        })  # fmt: skip


def _seconds(transforms: list[Transform]) -> Floats:
    stamps = np.array([each.stamp_ns for each in transforms], dtype=np.int64)
    return np.asarray((stamps - stamps[0]) / 1e9)


def _of_transform(at: str, numbers: Floats) -> Mapping[str, Floats]:
    names = [f"{at}.transform.translation.{axis}" for axis in "xyz"]
    names += [f"{at}.transform.rotation.{axis}" for axis in "xyzw"]
    return dict(zip(names, numbers.T, strict=True))
