"""The bytes of what robots say and hear on the radio.

An inbox has as many messages as were heard, so its layout changes from tick to tick; it is put together from
pieces that are encoded once per sender, in the alignment in which they will lie (CDR aligns numbers to their own
size, counted from the end of the encapsulation header).
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.alignment import MALFORMED, NUMBER_BYTES
from cocorosim_ros.wire.cdr.kernels.inbox_rows import rows_of_inbox
from cocorosim_ros.wire.cdr.primitives import ENCAPSULATION, Reader, pack_length, pack_numbers, pack_stamp, pack_text

Result = TypeVar("Result")


@dataclass(frozen=True)
class RadioMessage:
    """What one robot said."""

    stamp_ns: int  # of sending
    frame: str
    sender: str
    payload: tuple[float, ...]


class RadioEncoder:
    """Encodes messages and inboxes."""

    def __init__(self) -> None:
        self._pieces: dict[tuple[int, int], tuple[RadioMessage, bytes]] = {}
        self._pieces_of = -1

    def message(self, message: RadioMessage) -> bytes:
        """The bytes of a RadioMessage."""
        return ENCAPSULATION + pack_radio_message(message, 0)

    def inbox(self, stamp_ns: int, frame: str, heard: Sequence[RadioMessage]) -> bytes:
        """The bytes of a RadioInbox delivered at `stamp_ns`."""
        if stamp_ns != self._pieces_of:
            self._pieces, self._pieces_of = {}, stamp_ns
        parts = [pack_stamp(stamp_ns) + pack_text(frame) + pack_length(len(heard))]
        reached = len(parts[0])
        for message in heard:
            piece = self._piece_of_tick(message, reached % NUMBER_BYTES)
            parts.append(piece)
            reached += len(piece)
        return ENCAPSULATION + b"".join(parts)

    def _piece_of_tick(self, message: RadioMessage, phase: int) -> bytes:
        """The piece of a message that others hear at the same tick, encoded once; the same object means the same."""
        known = self._pieces.get((id(message), phase))
        if known is None:
            known = self._pieces[id(message), phase] = (
                message,
                pack_radio_message(message, phase),
            )  # held: its id stays its own
        return known[1]


def pack_radio_message(message: RadioMessage, phase: int) -> bytes:
    """One RadioMessage as it stands inside others, starting `phase` (0 or 4) bytes past a multiple of eight."""
    head = pack_stamp(message.stamp_ns) + pack_text(message.frame) + pack_text(message.sender)
    return head + pack_numbers(message.payload, phase + len(head))


def read_message(data: bytes) -> RadioMessage:
    """The RadioMessage in CDR bytes. Raises CocorosimError if they do not hold one."""
    return guarded(data, read_radio_message)


def read_inbox(data: bytes) -> list[RadioMessage]:
    """The messages of a RadioInbox in CDR bytes. Raises CocorosimError if they do not hold one."""

    def read(reader: Reader) -> list[RadioMessage]:
        reader.stamp_ns()
        reader.text()
        return [read_radio_message(reader) for _ in range(reader.length())]

    return guarded(data, read)


def hear(data: bytes | None, rows: Floats) -> int:
    """Write what a RadioInbox holds into `rows` (capacity, MESSAGE_SIZE); return the number of messages.

    No inbox: nothing was heard. Raises CocorosimError for bytes that hold something else.
    """
    if data is None:
        return 0
    found = MALFORMED
    if data[:2] == ENCAPSULATION[:2]:
        found = int(rows_of_inbox(np.frombuffer(data, dtype=np.uint8), rows))
    if found == MALFORMED:
        read_inbox(data)
        raise CocorosimError(f"{len(data)} bytes are not an inbox.")
    return found


def read_radio_message(reader: Reader) -> RadioMessage:
    """One RadioMessage as it stands inside others."""
    return RadioMessage(reader.stamp_ns(), reader.text(), reader.text(), reader.numbers())


def guarded(data: bytes, read: Callable[[Reader], Result], what: str = "a radio message") -> Result:
    """What `read` takes from CDR bytes. Raises CocorosimError if they do not hold `what`."""
    try:
        if data[:2] != ENCAPSULATION[:2]:
            raise ValueError("its byte order is not little endian")
        return read(Reader(data))
    except (struct.error, ValueError, UnicodeDecodeError) as error:
        raise CocorosimError(f"{len(data)} bytes are not {what}: {error}.") from error
