"""What is heard by sound as bytes: those of an independent serialiser, and back."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.acoustic_messages import AcousticMessage, encode_sounds, hear_sound, read_sounds
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage
from cocorosim_ros.wire.cdr.type_store import build, serialize
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH
from cocorosim_ros.world.state.sound import RANGE, SOUND_SIZE, VARIANCE

FRAME = "lily_07/base_link"


def sound(sender: str, *payload: float) -> AcousticMessage:
    """What a robot said, from 12.5 m away."""
    return AcousticMessage(RadioMessage(3_500_000_001, f"{sender}/base_link", sender, payload), 12.5, 0.25)


INBOXES = [
    [],
    [sound("lily_01", 0.1, -0.2)],
    [sound("x" * count, *map(float, range(count % 4))) for count in range(1, 10)],
]


def by_rosbags(stamp_ns: int, garbled: int, heard: list[AcousticMessage]) -> bytes:
    """The bytes of an inbox by the package `rosbags`."""

    def header(stamp: int, frame: str) -> dict[str, object]:
        return {"stamp": {"sec": stamp // 10**9, "nanosec": stamp % 10**9}, "frame_id": frame}

    messages = [
        {
            "header": header(each.message.stamp_ns, each.message.frame),
            "sender": each.message.sender,
            "payload": np.array(each.message.payload),
            "range": each.range,
            "variance": each.variance,
        }
        for each in heard
    ]
    values = {"header": header(stamp_ns, FRAME), "garbled": garbled, "messages": messages}
    return serialize(build("cocorosim_msgs/msg/AcousticInbox", values))


@pytest.mark.parametrize("heard", INBOXES)
@pytest.mark.parametrize("garbled", [0, 70_000])
def test_an_inbox_is_that_of_the_serialiser(heard: list[AcousticMessage], garbled: int) -> None:
    """Byte for byte, whatever the lengths, and read back it is what was heard."""
    data = encode_sounds(4_000_000_000, FRAME, garbled, heard)
    assert data == by_rosbags(4_000_000_000, garbled, heard)
    assert read_sounds(data) == (garbled, heard)


def test_rows() -> None:
    """Each row is the length of a payload, its numbers, range and variance; what exceeds the rows is left out."""
    rows = np.full((2, SOUND_SIZE), 7.0)
    data = encode_sounds(0, FRAME, 3, [sound("a", 1.0), sound("b"), sound("c", 2.0)])
    assert hear_sound(data, rows) == 2
    assert rows[:, MESSAGE_LENGTH].tolist() == [1.0, 0.0]
    assert rows[0, 1:3].tolist() == [1.0, 0.0]
    assert rows[:, RANGE].tolist() == [12.5, 12.5]
    assert rows[:, VARIANCE].tolist() == [0.25, 0.25]
    assert hear_sound(None, rows) == 0


def test_bytes_that_are_no_inbox() -> None:
    """Cut off anywhere: a sentence."""
    whole = encode_sounds(0, FRAME, 0, [sound("lily_01", 0.1)])
    for length in range(len(whole)):
        with pytest.raises(CocorosimError, match="acoustic inbox"):
            read_sounds(whole[:length])
