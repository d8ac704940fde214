"""The messages of one topic of any type, as the checks see them: times, numbers by path, frames, covariances."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np
from rosbags.serde import SerdeError

from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.diagnosis.evidence.topic_rows import TopicRows
from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_summary import RecordedTopic
from cocorosim_ros.wire.cdr.field_paths import fields_within, number_paths
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.conversion.formats.message_log import MessageLog

_NEVER_DECODED = ("sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage", "sensor_msgs/msg/PointCloud2")
_UNREADABLE = (SerdeError, IndexError, OverflowError, MemoryError, ValueError)


class Transform(NamedTuple):
    """One transform of a TFMessage: numbers are x, y, z [m] and a quaternion x, y, z, w."""

    log_ns: int
    stamp_ns: int
    parent: str
    child: str
    numbers: tuple[float, ...]


@dataclass(frozen=True)
class TopicLog:
    """n messages of one topic, in recorded order.

    stamp_ns: of the headers (n,) [ns]; None for a type without one. log_ns: when they were recorded (n,) [ns].
    checksums: of their bytes (n,). values: (n, columns) the single numbers, by path in `columns`. frames: the words in
    header.frame_id. child_frames: those in child_frame_id. covariances: by path the matrices (n, rows, rows).
    transforms: of TFMessages.
    """

    name: str
    type_name: str
    stamp_ns: Integers | None
    log_ns: Integers
    checksums: Integers
    columns: tuple[str, ...] = ()
    values: Floats = field(default_factory=lambda: np.empty((0, 0)))
    frames: frozenset[str] = frozenset()
    child_frames: frozenset[str] = frozenset()
    covariances: dict[str, Floats] = field(default_factory=dict)
    transforms: tuple[Transform, ...] = ()

    def has(self, *paths: str) -> bool:
        """Tell whether the messages have all of these numbers."""
        return self.values.size > 0 and set(paths) <= set(self.columns)

    def numbers(self, *paths: str) -> Floats:
        """(n, paths) these numbers."""
        return self.values[:, [self.columns.index(path) for path in paths]]

    def number(self, path: str) -> Floats:
        """(n,) one number."""
        return self.values[:, self.columns.index(path)]

    def vector(self, path: str, axes: str = "xyz") -> Floats | None:
        """(n, axes) the vector or quaternion at a path; None where the messages have none."""
        paths = [f"{path}.{axis}" for axis in axes]
        return self.numbers(*paths) if self.has(*paths) else None

    @property
    def quaternions(self) -> tuple[str, ...]:
        """The paths of all quaternions."""
        return tuple(path.removesuffix(".w") for path in self.columns if path.endswith(".w"))

    def rows(self, kept: Flags) -> TopicRows:
        """The messages where `kept` (n,) as the evidence of a diagnosis has them."""
        stamps = self.log_ns if self.stamp_ns is None else self.stamp_ns
        values = self.values if self.values.size else self.checksums[:, None].astype(np.float64)
        return TopicRows("", self.name, stamps[kept], self.log_ns[kept], values[kept])

    def time(self) -> Floats:
        """(n,) times [s] since the first message, by the stamps where there are any."""
        stamps = self.log_ns if self.stamp_ns is None else self.stamp_ns
        return np.asarray((stamps - stamps[0]) / 1e9)


def read_topics(log: MessageLog) -> Iterator[TopicLog]:
    """Every topic that has messages."""
    for recorded in log.topics:
        if recorded.count:
            yield _read(log, recorded)


def _read(log: MessageLog, recorded: RecordedTopic) -> TopicLog:
    messages = list(log.messages(recorded.topic))
    size = sum(len(data) for _, data in messages) / len(messages)
    decoded = [] if size > CHECKING.largest_message else _decoded(log, recorded, [data for _, data in messages])
    logged = np.array([time for time, _ in messages], dtype=np.int64)
    stamps = [
        log.header_stamp(recorded, data, decoded[row] if decoded else None) for row, (_, data) in enumerate(messages)
    ]
    known = None if None in stamps else np.array(stamps, dtype=np.int64)
    checksums = np.array([zlib.crc32(data) for _, data in messages], dtype=np.int64)
    topic = TopicLog(recorded.topic, recorded.type_name, known, logged, checksums)
    return _with_content(topic, decoded) if decoded else topic


def _decoded(log: MessageLog, recorded: RecordedTopic, data: list[bytes]) -> list[Any]:
    """The messages; none of a type that nothing tells, or that is a picture, or where one cannot be read."""
    if recorded.type_name in _NEVER_DECODED:
        return []
    try:
        decode = log.decoder(recorded)
        return [decode(each) for each in data]
    except (*_UNREADABLE, CocorosimError):
        return []


def _with_content(topic: TopicLog, messages: list[Any]) -> TopicLog:
    columns = tuple(path for path in number_paths(messages[0]) if not path.startswith("header."))
    values = np.empty((len(messages), 0))
    if columns:
        read = attrgetter(*columns)
        values = np.array([read(message) for message in messages], dtype=np.float64).reshape(len(messages), -1)
    headers = [message.header for message in messages if hasattr(message, "header")]
    return replace(
        topic,
        columns=columns,
        values=values,
        frames=frozenset(header.frame_id for header in headers),
        child_frames=frozenset(message.child_frame_id for message in messages if hasattr(message, "child_frame_id")),
        covariances={path: _matrices(messages, path) for path in _covariance_paths(messages[0])},
        transforms=tuple(_transforms(messages, topic.log_ns)),
    )


def _covariance_paths(message: Any) -> list[str]:
    """The paths of all square covariances."""
    return [
        path
        for path, value in fields_within(message)
        if "covariance" in path.rpartition(".")[2] and isinstance(value, np.ndarray) and value.size in (9, 36)
    ]


def _matrices(messages: list[Any], path: str) -> Floats:
    read = attrgetter(path)
    flat = np.array([read(message) for message in messages], dtype=np.float64)
    side = round(flat.shape[1] ** 0.5)
    return flat.reshape(-1, side, side)


def _transforms(messages: list[Any], log_ns: Integers) -> Iterator[Transform]:
    for message, logged in zip(messages, log_ns.tolist(), strict=True):
        for each in getattr(message, "transforms", ()):
            place, turn, stamp = each.transform.translation, each.transform.rotation, each.header.stamp
            numbers = (place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w)
            names = each.header.frame_id.strip("/"), each.child_frame_id.strip("/")
            yield Transform(logged, stamp.sec * NANOSECONDS + stamp.nanosec, *names, numbers)
