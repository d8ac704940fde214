"""Messages that are a header, names, and one float64 number for each name, decoded by the thousand.

So is ThrusterCommand, whatever its frame_id.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.wire.cdr.alignment import NUMBER_BYTES, aligned
from cocorosim_ros.wire.cdr.primitives import ByteOrder, Reader
from cocorosim_ros.wire.cdr.stamped_numbers import FRAME_LENGTH, PADDING, Stamps, decode_layout


@dataclass(frozen=True)
class NamedNumbers:
    """n messages in their order: header stamps (n,) [ns], numbers (n, names asked for), which could be read (n,).

    A number is NaN where the message does not name it. names: all that stand in the messages, in the order of their
    first appearance, some of them several times.
    """

    stamp_ns: Stamps
    numbers: Floats
    readable: Flags
    names: tuple[str, ...]


@dataclass(frozen=True)
class _Layout:
    """Messages that say the same but for stamp and numbers; `head` is what stands between these."""

    length: int
    order: ByteOrder
    head: bytes
    names: tuple[str, ...]
    place: int  # of the first number

    def holds(self, data: bytes) -> bool:
        return len(data) == self.length and data[FRAME_LENGTH : FRAME_LENGTH + len(self.head)] == self.head


def read_named_numbers(messages: Sequence[bytes], names: Sequence[str]) -> NamedNumbers:
    """The stamps of messages, and of each the numbers that have these names."""
    stamps = np.zeros(len(messages), dtype=np.int64)
    values = np.full((len(messages), len(names)), np.nan)
    readable = np.zeros(len(messages), dtype=bool)
    groups = _by_layout(messages)
    for layout, rows in groups:
        chosen = [messages[row] for row in rows]
        stamps[rows], numbers = decode_layout(chosen, layout.place, len(layout.names), layout.order)
        readable[rows] = True
        for column, name in enumerate(names):
            if name in layout.names:
                values[rows, column] = numbers[:, layout.names.index(name)]
    return NamedNumbers(stamps, values, readable, tuple(name for layout, _ in groups for name in layout.names))


def _by_layout(messages: Sequence[bytes]) -> list[tuple[_Layout, list[int]]]:
    groups: list[tuple[_Layout, list[int]]] = []
    for row, data in enumerate(messages):
        rows = next((rows for layout, rows in groups if layout.holds(data)), None)
        if rows is None:
            layout = _layout_of(data)
            if layout is None:
                continue
            rows = []
            groups.append((layout, rows))
        rows.append(row)
    return groups


def _layout_of(data: bytes) -> _Layout | None:
    """How this message is laid out; None if it is not whole."""
    reader = Reader(data)
    try:
        reader.stamp_ns()
        reader.text_bytes()
        names = [reader.text_bytes().rstrip(b"\0").decode(errors="replace") for _ in range(reader.length())]
        count = reader.length()
    except (struct.error, ValueError):
        return None
    place = aligned(reader.place, NUMBER_BYTES) if count else reader.place
    if count != len(names) or not 0 <= len(data) - place - NUMBER_BYTES * count <= PADDING:
        return None
    return _Layout(len(data), reader.order, data[FRAME_LENGTH : reader.place], tuple(names), place)
