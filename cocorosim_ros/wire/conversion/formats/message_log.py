"""Recordings of ROS as topics of messages, whatever file they are stored in."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, Protocol

from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.base import TypesysError

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_summary import RecordedTopic
from cocorosim_ros.wire.cdr import stamps, type_store

Decode = Callable[[bytes], Any]


class MessageLog(Protocol):
    """A recording of ROS."""

    name: str
    topics: tuple[RecordedTopic, ...]
    damage: tuple[str, ...]

    def messages(self, topic: str) -> Iterator[tuple[int, bytes]]:
        """Time of recording [ns] and bytes of every message of a topic, as recorded."""

    def decoder(self, recorded: RecordedTopic) -> Decode:
        """The function that makes messages from bytes."""

    def header_stamp(self, recorded: RecordedTopic, data: bytes, message: Any) -> int | None:
        """The time in a message's header [ns]; None for a type without one."""


class CdrMessages:
    """Messages in CDR, which all recordings of ROS 2 share."""

    def decoder(self, recorded: RecordedTopic) -> Decode:
        """The function for a topic's type; raises CocorosimError if nothing says what the type is."""
        store = _store_for(recorded)
        return lambda data: store.deserialize_cdr(data, recorded.type_name)

    def header_stamp(self, recorded: RecordedTopic, data: bytes, message: Any) -> int | None:
        """The time in a message's header [ns]; None for a type without one."""
        return stamps.stamp_ns(recorded.type_name, data, recorded.schema)


def _store_for(recorded: RecordedTopic) -> Any:
    """A store that knows the topic's type, from the text in the bag where Jazzy does not have it."""
    if type_store.is_known(recorded.type_name):
        return type_store.type_store()
    if not recorded.schema.strip():
        raise CocorosimError(
            f"{recorded.topic} has the type {recorded.type_name}, whose text the bag does not hold; leave the topic "
            "out, or convert the bag to MCAP by `ros2 bag convert` where the type's package is installed."
        )
    store = get_typestore(Stores.ROS2_JAZZY)
    try:
        found = get_types_from_msg(recorded.schema, recorded.type_name)
        store.register({name: fields for name, fields in found.items() if name not in store.fielddefs})
    except (TypesysError, ValueError) as error:
        raise CocorosimError(
            f"{recorded.topic} has the type {recorded.type_name}, whose text in the bag cannot be read; leave it out."
        ) from error
    return store
