"""The messages of one topic of a bag, of any type whose text the bag holds, as rows of numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from rosbags.serde import SerdeError

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.counted import counted, either
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, nearest
from cocorosim_ros.wire.cdr import field_paths
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.conversion.conversion_map import TimeMap
from cocorosim_ros.wire.conversion.formats.message_log import MessageLog
from cocorosim_ros.wire.conversion.rows import LATEST_NS, ColumnError, Stamps, no_messages


def _nothing_in(log: MessageLog) -> CocorosimError:
    """The error for a log without any message."""
    why = "".join(f" ({told.rstrip('.')})" for told in log.damage)
    return CocorosimError(
        f"{log.name} holds no whole message{why}: it is damaged, or nothing was recorded; copy it again or give "
        "another recording."
    )


class BagRows:
    """The messages of one topic in recorded order. Unreadable ones are left out, and `damage` says how many."""

    def __init__(self, log: MessageLog, topic: str, place: Entry) -> None:
        """Raises TopicError if the log has no such topic, another CocorosimError if nothing of it can be read."""
        recorded = next((entry for entry in log.topics if entry.topic == topic and entry.count), None)
        if recorded is None:
            known = [entry.topic for entry in log.topics if entry.count]
            if not known:
                raise _nothing_in(log)
            raise no_messages(topic, known, place, log.name)
        self.origin = f"{topic} of {log.name}"
        self._type = recorded.type_name
        decode = log.decoder(recorded)
        self._messages: list[Any] = []
        self._logged: list[int] = []
        self._headed: list[int | None] = []
        unreadable = 0
        for log_time_ns, data in log.messages(topic):
            try:
                decoded = decode(data)
            except (SerdeError, IndexError, OverflowError, MemoryError, ValueError):
                unreadable += 1
                continue
            self._messages.append(decoded)
            self._logged.append(log_time_ns)
            self._headed.append(log.header_stamp(recorded, data, decoded))
        self.count = len(self._messages)
        lost = f"{counted(unreadable, 'message')} cannot be read and {either(unreadable, 'was', 'were')} left out"
        self.damage = f"{self.origin}: {lost}." if unreadable else ""
        if not self._messages:
            raise CocorosimError(f"No message of {self.origin} is a {self._type}; record it again or leave it out.")

    @property
    def columns(self) -> tuple[str, ...]:
        """The paths of all numbers in its first message."""
        return tuple(sorted(field_paths.number_paths(self._messages[0])))

    def row_name(self, row: int) -> str:
        """The message, counted from 1."""
        return f"message {row + 1}"

    def numbers(self, column: Entry) -> Floats:
        """(n,) the field at a path; NaN where a message lacks that element of a list."""
        try:
            return np.array([float(value) for value in self._fields(column)], dtype=np.float64)
        except (TypeError, ValueError) as error:
            raise column.problem(f"has {column.found()}, which is no number in {self.origin}; name another.") from error

    def words(self, column: Entry) -> list[str]:
        """The field at a path, as text; 'nan' where a message lacks that element of a list."""
        return [str(value) for value in self._fields(column)]

    def stamps(self, when: TimeMap) -> tuple[Stamps, Flags]:
        """(n,) times [ns]: at a path, or of the header, or when recorded if the type has no header."""
        if when.stamp is not None:
            found = [_nanoseconds(value) for value in self._fields(when.stamp)]
            if all(time is None for time in found):
                raise when.stamp.problem(f"has {when.stamp.found()}, which is no time in {self.origin}.")
        elif when.log_time:
            found = list(self._logged)
        else:
            found = [log if time is None else time for time, log in zip(self._headed, self._logged, strict=True)]
        shifted = [0 if time is None else time + when.start_ns for time in found]
        if min(shifted) < 0 or max(shifted) > LATEST_NS:
            raise CocorosimError(f"{self.origin} has times before 0 s; add 'start' to its 'time' in the map.")
        return np.array(shifted, dtype=np.int64), np.array([time is not None for time in found])

    def _fields(self, column: Entry) -> list[Any]:
        try:
            path = field_paths.steps(str(column.value))
            return [_at(message, path) for message in self._messages]
        except ValueError as error:
            raise column.problem(f"has {column.found()}, which is no path like pose.position.x.") from error
        except AttributeError as error:
            known = nearest(str(column.value), self.columns)
            told = f"has {column.found()}, no field of {self.origin} ({self._type}){known}."
            raise ColumnError(str(column.problem(told))) from error
        except TypeError as error:
            raise column.problem(f"has {column.found()}, which leads to no single value in {self._type}.") from error


def _at(message: Any, path: Sequence[field_paths.Step]) -> Any:
    """The value at a path; NaN where the message lacks that element. Raises TypeError for a list or a message."""
    for field, element in path:
        owner, message = message, getattr(message, field)
        if element is not None:
            index = field_paths.position(owner, field, element)
            if index is None:
                return float("nan")
            message = message[index]
    if isinstance(message, (list, np.ndarray)):
        raise TypeError("a list")
    if hasattr(message, "__msgtype__") and not hasattr(message, "nanosec"):
        raise TypeError("a message")
    return message


def _nanoseconds(value: Any) -> int | None:
    return value.sec * NANOSECONDS + value.nanosec if hasattr(value, "nanosec") else None
