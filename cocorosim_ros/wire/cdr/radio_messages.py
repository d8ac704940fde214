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
from cocorosim_ros.wire.cdr.kernels.inbox_rows import MALFORMED, rows_of_inbox
from cocorosim_ros.wire.cdr.stamps import NANOSECONDS

Result = TypeVar("Result")
ENCAPSULATION = b"\x00\x01\x00\x00"  # CDR, little endian


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
        self._texts: dict[str, bytes] = {}
        self._pieces: dict[tuple[int, int], tuple[RadioMessage, bytes]] = {}
        self._pieces_of = -1

    def message(self, message: RadioMessage) -> bytes:
        """The bytes of a RadioMessage."""
        return ENCAPSULATION + self.piece(message, 0)

    def inbox(self, stamp_ns: int, frame: str, heard: Sequence[RadioMessage]) -> bytes:
        """The bytes of a RadioInbox delivered at `stamp_ns`."""
        if stamp_ns != self._pieces_of:
            self._pieces, self._pieces_of = {}, stamp_ns
        parts = [_stamp(stamp_ns) + self._text(frame), struct.pack("<I", len(heard))]
        length = len(parts[0]) + 4
        for message in heard:
            piece = self._piece_of_tick(message, length % 8)
            parts.append(piece)
            length += len(piece)
        return ENCAPSULATION + b"".join(parts)

    def _piece_of_tick(self, message: RadioMessage, phase: int) -> bytes:
        """The piece of a message that others hear at the same tick, encoded once; the same object means the same."""
        known = self._pieces.get((id(message), phase))
        if known is None:
            known = self._pieces[id(message), phase] = message, self.piece(message, phase)  # held: its id stays its own
        return known[1]

    def piece(self, message: RadioMessage, phase: int) -> bytes:
        """One RadioMessage as it stands inside others, starting `phase` (0 or 4) bytes past a multiple of eight."""
        head = _stamp(message.stamp_ns) + self._text(message.frame) + self._text(message.sender)
        head += struct.pack("<I", len(message.payload))
        padding = -(phase + len(head)) % 8 if message.payload else 0
        return head + bytes(padding) + struct.pack(f"<{len(message.payload)}d", *message.payload)

    def _text(self, text: str) -> bytes:
        """A string with its length before it, padded so that the next one can follow."""
        if text not in self._texts:
            data = text.encode() + b"\x00"
            self._texts[text] = struct.pack("<I", len(data)) + data + bytes(-len(data) % 4)
        return self._texts[text]


def read_message(data: bytes) -> RadioMessage:
    """The RadioMessage in CDR bytes. Raises CocorosimError if they do not hold one."""
    return _guarded(data, _read_piece)


def read_inbox(data: bytes) -> list[RadioMessage]:
    """The messages of a RadioInbox in CDR bytes. Raises CocorosimError if they do not hold one."""

    def read(reader: _Reader) -> list[RadioMessage]:
        reader.stamp_ns()
        reader.text()
        return [_read_piece(reader) for _ in range(reader.count())]

    return _guarded(data, read)


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


class _Reader:
    """Walks through little-endian CDR bytes; big-endian ones are refused."""

    def __init__(self, data: bytes) -> None:
        if data[:2] != ENCAPSULATION[:2]:
            raise ValueError("its byte order is not little endian")
        self._data = data
        self._at = 4

    def count(self) -> int:
        self._at += -self._at % 4
        (value,) = struct.unpack_from("<I", self._data, self._at)
        self._at += 4
        if value > len(self._data):
            raise ValueError("a length in it exceeds its size")
        return int(value)

    def stamp_ns(self) -> int:
        self._at += -self._at % 4
        seconds, nanoseconds = struct.unpack_from("<iI", self._data, self._at)
        self._at += 8
        return int(seconds) * NANOSECONDS + int(nanoseconds)

    def text(self) -> str:
        length = self.count()
        data = self._data[self._at : self._at + length]
        self._at += length
        return data[:-1].decode()

    def numbers(self) -> tuple[float, ...]:
        count = self.count()
        if count == 0:
            return ()
        self._at += -(self._at - 4) % 8
        values = struct.unpack_from(f"<{count}d", self._data, self._at)
        self._at += 8 * count
        return values


def _read_piece(reader: _Reader) -> RadioMessage:
    return RadioMessage(reader.stamp_ns(), reader.text(), reader.text(), reader.numbers())


def _stamp(stamp_ns: int) -> bytes:
    return struct.pack("<iI", *divmod(stamp_ns, NANOSECONDS))


def _guarded(data: bytes, read: Callable[[_Reader], Result]) -> Result:
    try:
        return read(_Reader(data))
    except (struct.error, ValueError, UnicodeDecodeError) as error:
        raise CocorosimError(f"{len(data)} bytes are not a radio message: {error}.") from error
