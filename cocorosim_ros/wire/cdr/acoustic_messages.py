"""The bytes of what robots hear by sound: messages as on the radio, each with its range."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr.alignment import NUMBER_BYTES
from cocorosim_ros.wire.cdr.primitives import ENCAPSULATION, Reader, pack_length, pack_stamp, pack_text, padding
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage, guarded, pack_radio_message, read_radio_message
from cocorosim_ros.world.state.radio import MESSAGE_SIZE, write_payload
from cocorosim_ros.world.state.sound import RANGE, VARIANCE

_PAIR = struct.Struct("<2d")


@dataclass(frozen=True)
class AcousticMessage:
    """What one robot said, as another one heard it; range [m] and its variance [m^2]."""

    message: RadioMessage
    range: float
    variance: float


def encode_sounds(stamp_ns: int, frame: str, garbled: int, heard: Sequence[AcousticMessage]) -> bytes:
    """The bytes of an AcousticInbox delivered at `stamp_ns`; `garbled` sounds were not understood."""
    body = pack_stamp(stamp_ns) + pack_text(frame) + pack_length(garbled) + pack_length(len(heard))
    for sound in heard:
        body += pack_radio_message(sound.message, len(body) % NUMBER_BYTES)
        body += padding(len(body), NUMBER_BYTES) + _PAIR.pack(sound.range, sound.variance)
    return ENCAPSULATION + body


def read_sounds(data: bytes) -> tuple[int, list[AcousticMessage]]:
    """How many sounds were garbled, and the messages, in the bytes of an AcousticInbox. Raises CocorosimError."""

    def read(reader: Reader) -> tuple[int, list[AcousticMessage]]:
        reader.stamp_ns()
        reader.text()
        garbled = reader.whole()
        return garbled, [
            AcousticMessage(read_radio_message(reader), reader.number(), reader.number())
            for _ in range(reader.length())
        ]

    return guarded(data, read, "an acoustic inbox")


def hear_sound(data: bytes | None, rows: Floats) -> int:
    """Write what an AcousticInbox holds into `rows` (capacity, SOUND_SIZE); return the number of messages.

    No inbox: nothing was heard; what exceeds the capacity is left out. Raises CocorosimError for other bytes.
    """
    if data is None:
        return 0
    heard = read_sounds(data)[1][: len(rows)]
    for row, sound in zip(rows, heard, strict=False):
        write_payload(row[:MESSAGE_SIZE], sound.message.payload)
        row[RANGE], row[VARIANCE] = sound.range, sound.variance
    return len(heard)
