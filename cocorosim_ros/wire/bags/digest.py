"""One number for a whole recording: equal digests mean, topic by topic, the same stamps and CDR bytes.

The digest of a topic is the sha256 over (stamp [ns, int64], length [uint64], bytes) of its messages in
recorded order; that of the recording is the sha256 over the lines `topic type count digest` of all topics
that have messages, sorted. When a message was received and how topics interleave does not matter. A message
without a stamp counts with its log time. Topics that are drawn from the rest for viewers (robots as URDF,
markers) are left out, so that a recording with them and one without are equal.
"""

from __future__ import annotations

import hashlib
import struct

from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.topics.topics import is_drawn

_pack_head = struct.Struct("<qQ").pack


class TopicDigest:
    """The digest of one topic, message by message."""

    def __init__(self, topic: str, type_name: str, schema: str = "") -> None:
        self.topic = topic
        self.type_name = type_name
        self.count = 0
        self._schema = schema
        self._hash = hashlib.sha256()

    def add(self, log_time_ns: int, data: bytes) -> None:
        """Take the topic's next message."""
        stamp = stamp_ns(self.type_name, data, self._schema)
        self._hash.update(_pack_head(log_time_ns if stamp is None else stamp, len(data)) + data)
        self.count += 1

    def line(self) -> str:
        """Topic, type, count and digest of what was added so far."""
        return f"{self.topic} {self.type_name} {self.count} {self._hash.hexdigest()}"


class Digest:
    """The digest of a recording, message by message."""

    def __init__(self) -> None:
        self.topics: dict[tuple[str, str], TopicDigest] = {}

    def topic(self, topic: str, type_name: str, schema: str = "") -> TopicDigest:
        """The digest of this topic and type, which is begun if it is new."""
        key = (topic, type_name)
        if key not in self.topics:
            self.topics[key] = TopicDigest(topic, type_name, schema)
        return self.topics[key]

    def add(self, topic: str, type_name: str, log_time_ns: int, data: bytes) -> None:
        """Take the next message of a topic whose type the type store knows."""
        self.topic(topic, type_name).add(log_time_ns, data)

    def lines(self) -> list[str]:
        """`topic type count digest` of every topic that counts and has messages, sorted."""
        return sorted(each.line() for each in self.topics.values() if each.count and not is_drawn(each.topic))

    def hexdigest(self) -> str:
        """The digest of all that was added so far, as 64 hexadecimal digits."""
        return hashlib.sha256("\n".join(self.lines()).encode()).hexdigest()
