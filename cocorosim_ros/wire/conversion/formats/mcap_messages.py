"""Recordings of ROS 2 in MCAP files."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.conversion.formats.message_log import CdrMessages


class McapMessages(CdrMessages):
    """A folder with MCAP files, or one such file."""

    def __init__(self, path: Path) -> None:
        """Raises CocorosimError if there is no recording."""
        self._bag = read_bag(path)
        self.name = self._bag.path.name
        self.topics = self._bag.summary.topics
        self.damage: tuple[str, ...] = (self._bag.summary.damage,) if self._bag.summary.damage else ()

    def messages(self, topic: str) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and bytes of every message of a topic, as recorded."""
        for message in self._bag.messages([topic]):
            yield message.log_time_ns, message.data
