"""What every message is made of: stamps, lengths, texts and float64 numbers, to CDR bytes and back.

Written little endian, read in either byte order. Whatever puts bytes together or takes them apart by hand does it
with these; a whole message of a known type is the type store's to read.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from functools import lru_cache
from typing import Literal, TypeVar

from cocorosim_ros.foundation.arrays import Integers
from cocorosim_ros.wire.cdr.alignment import BODY, LENGTH_BYTES, NUMBER_BYTES, STAMP_BYTES, aligned

ByteOrder = Literal["<", ">"]
Whole = TypeVar("Whole", int, Integers)

NANOSECONDS = 1_000_000_000
ENCAPSULATION = b"\x00\x01\x00\x00"  # CDR, little endian
TEXTS_KEPT = 4096  # names and frames come again at every tick

LENGTH, STAMP, COUNTER = struct.Struct("<I"), struct.Struct("<iI"), struct.Struct("<Q")
BIG_LENGTH, BIG_STAMP, BIG_COUNTER = struct.Struct(">I"), struct.Struct(">iI"), struct.Struct(">Q")


def pack_stamp(stamp_ns: int) -> bytes:
    """The 8 bytes of a builtin_interfaces/Time."""
    return STAMP.pack(*divmod(stamp_ns, NANOSECONDS))


def stamp_words(stamp_ns: Whole) -> Whole:
    """Stamps [ns] as the 8 bytes that CDR holds, read as one int64: seconds (int32) below nanoseconds (uint32)."""
    return (stamp_ns % NANOSECONDS << 32) | (stamp_ns // NANOSECONDS & 0xFFFFFFFF)


def pack_length(count: int) -> bytes:
    """What stands before the elements of a list."""
    return LENGTH.pack(count)


@lru_cache(maxsize=TEXTS_KEPT)
def pack_text(value: str) -> bytes:
    """A string with its length before it and its end mark, padded so that a length or a stamp can follow."""
    data = value.encode() + b"\x00"
    return LENGTH.pack(len(data)) + data + padding(len(data), LENGTH_BYTES)


def pack_counter(value: int) -> bytes:
    """The 8 bytes of a uint64."""
    return COUNTER.pack(value)


def pack_numbers(values: Iterable[float], phase: int) -> bytes:
    """A list of float64, which begins `phase` bytes behind the encapsulation header (or a multiple of 8 more)."""
    given = tuple(values)
    before = padding(phase + LENGTH_BYTES, NUMBER_BYTES) if given else b""
    return LENGTH.pack(len(given)) + before + struct.pack(f"<{len(given)}d", *given)


def padding(count: int, size: int) -> bytes:
    """Zeros that fill `count` bytes up to a multiple of `size`."""
    return bytes(-count % size)


def byte_order(data: bytes) -> ByteOrder:
    """Of CDR bytes, as `struct` and NumPy write it: the last bit of the representation identifier tells."""
    return ">" if len(data) > 1 and not data[1] & 1 else "<"


class Reader:
    """Takes primitives from CDR bytes one after the other, each from where it is aligned.

    Raises ValueError or struct.error where the bytes end or a length exceeds them.
    """

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.order = byte_order(data)
        self.place = BODY
        little = self.order == "<"
        self._length, self._stamp = (LENGTH, STAMP) if little else (BIG_LENGTH, BIG_STAMP)

    def stamp_ns(self) -> int:
        """A builtin_interfaces/Time [ns]."""
        place = aligned(self.place, LENGTH_BYTES)
        seconds, nanoseconds = self._stamp.unpack_from(self.data, place)
        self.place = place + STAMP_BYTES
        return int(seconds * NANOSECONDS + nanoseconds)

    def length(self) -> int:
        """How many elements follow, or how many bytes of a text."""
        value = self.whole()
        if value > len(self.data):
            raise ValueError("a length in it exceeds its size")
        return value

    def whole(self) -> int:
        """A uint32 that is no length."""
        place = aligned(self.place, LENGTH_BYTES)
        (value,) = self._length.unpack_from(self.data, place)
        self.place = place + LENGTH_BYTES
        return int(value)

    def number(self) -> float:
        """A float64."""
        place = aligned(self.place, NUMBER_BYTES)
        (value,) = struct.unpack_from(f"{self.order}d", self.data, place)
        self.place = place + NUMBER_BYTES
        return float(value)

    def text_bytes(self) -> bytes:
        """A string as it stands there, with its end mark."""
        count = self.length()
        begin, self.place = self.place, self.place + count
        return self.data[begin : self.place]

    def text(self) -> str:
        """A string. Raises UnicodeDecodeError, a ValueError, if it is none."""
        return self.text_bytes()[:-1].decode()

    def numbers(self) -> tuple[float, ...]:
        """A list of float64."""
        count = self.length()
        if count == 0:
            return ()
        place = aligned(self.place, NUMBER_BYTES)
        values = struct.unpack_from(f"{self.order}{count}d", self.data, place)
        self.place = place + NUMBER_BYTES * count
        return values

    def counter(self) -> int:
        """A uint64."""
        place = aligned(self.place, NUMBER_BYTES)
        (value,) = (COUNTER if self.order == "<" else BIG_COUNTER).unpack_from(self.data, place)
        self.place = place + NUMBER_BYTES
        return int(value)
