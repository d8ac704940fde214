"""Recordings of ROS 2 in SQLite files, as `ros2 bag record` wrote them before Iron.

Tables: topics (id, name, type), messages (topic_id, timestamp [ns], data), and since Iron message_definitions
(topic_type, encoding, encoded_message_definition).
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import closing
from pathlib import Path
from typing import Any
from urllib.parse import quote

from cocorosim_ros.wire.bags.bag_summary import RecordedTopic
from cocorosim_ros.wire.conversion.formats.format import check_file, unreadable
from cocorosim_ros.wire.conversion.formats.message_log import CdrMessages

_SUMMARY = "a rosbag2 recording in SQLite"


class SqliteMessages(CdrMessages):
    """One or more .db3 files of one recording."""

    damage: tuple[str, ...] = ()

    def __init__(self, name: str, files: Sequence[Path]) -> None:
        """Raises CocorosimError if a file is no rosbag2 recording, or damaged."""
        self.name = name
        self._files = files
        for file in files:
            check_file(file, file.name, _SUMMARY, ("sqlite",))
        self.topics = tuple(topic for file in files for topic in _topics(file))

    def messages(self, topic: str) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and bytes of every message of a topic, in the order of the times."""
        question = (
            "SELECT timestamp, data FROM messages WHERE topic_id IN (SELECT id FROM topics WHERE name = ?) "
            "ORDER BY timestamp, id"
        )
        for file in self._files:
            yield from ((int(stamp), bytes(data)) for stamp, data in _answers(file, question, (topic,)))


def _topics(file: Path) -> Iterator[RecordedTopic]:
    texts: dict[str, tuple[str, str]] = {}
    if any(_answers(file, "SELECT name FROM sqlite_master WHERE name = 'message_definitions'")):
        for name, encoding, text in _answers(
            file, "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions"
        ):
            texts[name] = (text, encoding)
    question = (
        "SELECT topics.name, topics.type, count(messages.id) FROM topics "
        "LEFT JOIN messages ON messages.topic_id = topics.id GROUP BY topics.id ORDER BY topics.name"
    )
    for topic, type_name, count in _answers(file, question):
        schema, encoding = texts.get(type_name, ("", ""))
        yield RecordedTopic(topic, type_name, count, schema, encoding, "", "")


def _answers(file: Path, question: str, values: tuple[str, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The rows that answer a question, the file left as it is."""
    try:
        with closing(sqlite3.connect(f"file:{quote(str(file.absolute()))}?immutable=1", uri=True)) as connection:
            yield from connection.execute(question, values)
    except sqlite3.Error as error:
        raise unreadable(file.name, _SUMMARY, error) from error
