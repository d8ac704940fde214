"""Recordings of ROS 1 (version 2.0 of the format)."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from rosbags.rosbag1 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.base import TypesysError

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_summary import RecordedTopic
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.conversion.formats.format import unreadable
from cocorosim_ros.wire.conversion.formats.message_log import Decode

_SUMMARY = "a ROS 1 bag"


class Ros1Messages:
    """One .bag file. Every message is decoded by the text of its type in the bag."""

    damage: tuple[str, ...] = ()

    def __init__(self, path: Path) -> None:
        """Raises CocorosimError if the bag is damaged or was not closed."""
        self.name = path.name
        self._path = path
        try:
            with Reader(path) as reader:
                self.topics = tuple(
                    RecordedTopic(found.topic, found.msgtype, found.msgcount, str(found.msgdef.data), "ros1msg", "", "")
                    for found in reader.connections
                )
        except Exception as error:  # a parser that meets damage may raise anything
            if "not indexed" in str(error):
                raise CocorosimError(
                    f"{path.name} was not closed when it was recorded; repair it by `rosbag reindex {path.name}`."
                ) from error
            raise unreadable(path.name, _SUMMARY, error) from error

    def messages(self, topic: str) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and bytes of every message of a topic, in the order of the times."""
        try:
            with Reader(self._path) as reader:
                mine = [found for found in reader.connections if found.topic == topic]
                for _, stamp, data in reader.messages(mine):
                    yield stamp, data
        except Exception as error:  # a parser that meets damage may raise anything
            raise unreadable(self.name, _SUMMARY, error) from error

    def decoder(self, recorded: RecordedTopic) -> Decode:
        """The function for a topic's type; raises CocorosimError if its text in the bag cannot be read."""
        store = get_typestore(Stores.EMPTY)
        try:
            store.register(get_types_from_msg(recorded.schema, recorded.type_name))
        except (TypesysError, ValueError) as error:
            raise CocorosimError(
                f"{recorded.topic} has the type {recorded.type_name}, whose text in the bag cannot be read; leave it "
                "out."
            ) from error
        return lambda data: store.deserialize_ros1(data, recorded.type_name)

    def header_stamp(self, recorded: RecordedTopic, data: bytes, message: Any) -> int | None:
        """The time in a message's header [ns]; None for a type without one."""
        stamp = getattr(getattr(message, "header", None), "stamp", None)
        return None if stamp is None else stamp.sec * NANOSECONDS + stamp.nanosec
