"""Radio messages and inboxes as bytes: those of an independent serialiser, and back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.radio_messages import RadioEncoder, RadioMessage, hear, read_inbox, read_message
from cocorosim_ros.wire.cdr.type_store import build, serialize
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, PAYLOAD_LIMIT

FRAME = "lily_07/base_link"


def said(sender: str, *payload: float, stamp_ns: int = 3_500_000_001) -> RadioMessage:
    """What a robot said."""
    return RadioMessage(stamp_ns, f"{sender}/base_link", sender, payload)


INBOXES: dict[str, list[RadioMessage]] = {
    "nothing": [],
    "one": [said("lily_01", 0.1, -0.2, 0.3)],
    "lengths of names": [said("x" * count, 1.5, float(count)) for count in range(1, 12)],
    "lengths of payloads": [
        said("a" * (1 + count % 5), *map(float, range(count))) for count in range(PAYLOAD_LIMIT + 1)
    ],
    "no frames": [RadioMessage(0, "", "", (1.0,)), RadioMessage(0, "", "", ())],
    "other letters": [said("Fisch_\u00e4\u00f6", 1.0), said("\u9c7c", 2.0)],
}
every_inbox = pytest.mark.parametrize("heard", INBOXES.values(), ids=INBOXES.keys())


def fields(message: RadioMessage) -> dict[str, Any]:
    """A RadioMessage's fields by name."""
    stamp = {"sec": message.stamp_ns // 10**9, "nanosec": message.stamp_ns % 10**9}
    header = {"stamp": stamp, "frame_id": message.frame}
    return {"header": header, "sender": message.sender, "payload": np.array(message.payload)}


def inbox_by_rosbags(stamp_ns: int, heard: list[RadioMessage]) -> bytes:
    """The bytes of an inbox by the package `rosbags`."""
    header = {"stamp": {"sec": stamp_ns // 10**9, "nanosec": stamp_ns % 10**9}, "frame_id": FRAME}
    return serialize(build("cocorosim_msgs/msg/RadioInbox", {"header": header, "messages": list(map(fields, heard))}))


@every_inbox
def test_an_inbox_is_that_of_the_serialiser(heard: list[RadioMessage]) -> None:
    """Byte for byte, whatever lengths names and payloads have, and read back it is what was heard."""
    data = RadioEncoder().inbox(4_000_000_000, FRAME, heard)
    assert data == inbox_by_rosbags(4_000_000_000, heard)
    assert read_inbox(data) == heard


def test_pieces_of_one_tick_are_those_of_the_next() -> None:
    """An encoder that has encoded messages before gives the bytes of a fresh one: other receivers, phases, ticks."""
    encoder, draw = RadioEncoder(), np.random.default_rng(1)
    for tick in range(5):
        everybody = [
            said("ab"[: 1 + robot % 2] * robot, *draw.uniform(size=robot % 4), stamp_ns=tick) for robot in range(6)
        ]
        for receiver in range(6):
            heard = [message for message in everybody if draw.uniform() < 0.7]
            heard += [said("noise", *draw.uniform(size=2))]  # one that nobody else has, gone after this line
            assert encoder.inbox(tick, FRAME, heard) == inbox_by_rosbags(tick, heard), receiver


@every_inbox
@pytest.mark.parametrize("capacity", [3, 64])
def test_what_is_heard(heard: list[RadioMessage], capacity: int) -> None:
    """Each row is the length of a payload, its numbers, and zeros; where there are too many the first count."""
    rows = np.full((capacity, MESSAGE_SIZE), 7.0)
    count = hear(RadioEncoder().inbox(0, FRAME, heard), rows)
    assert count == min(len(heard), capacity)
    for row, message in zip(rows[:count], heard, strict=False):
        assert row[MESSAGE_LENGTH] == len(message.payload)
        assert tuple(row[1 : 1 + len(message.payload)]) == message.payload
        assert not row[1 + len(message.payload) :].any()
    assert (rows[count:] == 7.0).all()


def test_long_payloads_are_cut_and_the_next_message_is_found() -> None:
    """Of 11 numbers the first 8 are kept; what follows is read from behind the eleventh."""
    rows = np.zeros((2, MESSAGE_SIZE))
    assert hear(RadioEncoder().inbox(0, FRAME, [said("a", *map(float, range(11))), said("bc", 5.0)]), rows) == 2
    assert rows[0].tolist() == [8.0, *map(float, range(8))]
    assert rows[1, :2].tolist() == [1.0, 5.0]


def test_nothing_was_heard() -> None:
    """Where no inbox is there."""
    assert hear(None, np.zeros((1, MESSAGE_SIZE))) == 0


def test_bytes_that_are_no_inbox() -> None:
    """Cut off anywhere, big-endian, or of lengths beyond reason: a sentence, never a wrong number."""
    whole = RadioEncoder().inbox(0, FRAME, [said("lily_01", 0.1, 0.2), said("lily_02", 0.3)])
    broken = [whole[:length] for length in range(len(whole))]
    broken += [b"\x00\x00" + whole[2:], whole[:12] + b"\xff\xff\xff\xff" + whole[16:]]
    broken += [whole[:36] + b"\xff\xff\xff\x7f" + whole[40:]]
    rows = np.zeros((4, MESSAGE_SIZE))
    for data in broken:
        with pytest.raises(CocorosimError, match=f"{len(data)} bytes are not"):
            hear(data, rows)
    with pytest.raises(CocorosimError, match="not a radio message"):
        read_message(whole[:11])
