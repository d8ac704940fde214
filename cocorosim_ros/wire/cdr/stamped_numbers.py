"""Messages that are a header and float64 numbers, nothing else, decoded by the thousand.

So are PoseStamped, TwistStamped, Imu, FluidPressure and Compass, whatever their frame_id.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from rosbags.interfaces import Nodetype

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.wire.cdr.alignment import BODY, LENGTH_BYTES, NUMBER_BYTES, STAMP_BYTES, aligned
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS, ByteOrder, byte_order
from cocorosim_ros.wire.cdr.type_store import type_store

FRAME_LENGTH = BODY + STAMP_BYTES  # byte offsets in the CDR bytes
FRAME = FRAME_LENGTH + LENGTH_BYTES
PADDING = 3  # bytes at most behind the last number

Stamps = Integers


@dataclass(frozen=True)
class StampedNumbers:
    """n messages in their order: header stamps (n,) [ns], numbers (n, count), which of them could be read (n,).

    An unreadable one has the stamp zero and the numbers NaN. frames: the frame_ids.
    """

    stamp_ns: Stamps
    numbers: Floats
    readable: Flags
    frames: tuple[str, ...]


@cache
def numbers_of(type_name: str) -> tuple[str, ...]:
    """Paths (`field_paths`) of the numbers of a type that is a header and float64 numbers, in order; () for another."""
    fields = type_store().fielddefs[type_name][1]
    if not fields or fields[0] != ("header", (Nodetype.NAME, "std_msgs/msg/Header")):
        return ()
    paths = [_paths(*field) for field in fields[1:]]
    return () if any(None in part for part in paths) else tuple(str(path) for part in paths for path in part)


def _paths(name: str, description: Any) -> list[str | None]:
    """Paths of the numbers in a field; None for what is no float64."""
    kind, detail = description
    if kind == Nodetype.NAME:
        inner = [path for field in type_store().fielddefs[detail][1] for path in _paths(*field)]
        return [f"{name}.{path}" if path else None for path in inner]
    element, count = (detail, 0) if kind == Nodetype.BASE else detail
    if kind == Nodetype.ARRAY and element == (Nodetype.BASE, ("float64", 0)):
        return [f"{name}[#{index}]" for index in range(count)]
    return [name if kind == Nodetype.BASE and element[0] == "float64" else None]


def read_stamped_numbers(messages: Sequence[bytes], count: int) -> StampedNumbers:
    """The stamps and the `count` numbers of messages of one type, of any frame_ids and byte orders."""
    stamps = np.zeros(len(messages), dtype=np.int64)
    numbers = np.full((len(messages), count), np.nan)
    readable = np.zeros(len(messages), dtype=bool)
    frames: set[str] = set()
    for (frame, order), rows in _by_layout(messages, count).items():
        place = aligned(FRAME + len(frame), NUMBER_BYTES)
        stamps[rows], numbers[rows] = decode_layout([messages[row] for row in rows], place, count, order)
        readable[rows] = True
        frames.add(frame.rstrip(b"\0").decode(errors="replace"))
    return StampedNumbers(stamps, numbers, readable, tuple(sorted(frames)))


def decode_layout(messages: Sequence[bytes], place: int, count: int, order: ByteOrder) -> tuple[Stamps, Floats]:
    """(n,) stamps [ns] and (n, count) numbers of messages whose numbers begin at one place."""
    end = place + NUMBER_BYTES * count
    layout = np.dtype(
        {
            "names": ["seconds", "nanoseconds", "numbers"],
            "formats": [f"{order}i4", f"{order}u4", (f"{order}f8", (count,))],
            "offsets": [BODY, BODY + STAMP_BYTES // 2, place],
            "itemsize": end,
        }
    )
    table = np.frombuffer(b"".join(data[:end] for data in messages), dtype=layout)
    stamps = table["seconds"].astype(np.int64) * NANOSECONDS + table["nanoseconds"]
    return stamps, table["numbers"].astype(np.float64)


def _by_layout(messages: Sequence[bytes], count: int) -> dict[tuple[bytes, ByteOrder], list[int]]:
    """Rows of the readable messages by frame_id (as in the bytes, with its end mark) and byte order."""
    groups: dict[tuple[bytes, ByteOrder], list[int]] = {}
    for row, data in enumerate(messages):
        order = byte_order(data)
        length = int.from_bytes(data[FRAME_LENGTH:FRAME], "big" if order == ">" else "little")
        if 0 <= len(data) - aligned(FRAME + length, NUMBER_BYTES) - NUMBER_BYTES * count <= PADDING:
            groups.setdefault((data[FRAME : FRAME + length], order), []).append(row)
    return groups
