"""The bytes of `neighbours`: how many there are changes from tick to tick, so the layout does too."""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.radio_messages import ENCAPSULATION
from cocorosim_ros.wire.cdr.stamps import NANOSECONDS

TYPE = "cocorosim_msgs/msg/Neighbours"


def encode_neighbours(stamp_ns: int, frame: str, names: Sequence[str], offset: Floats, velocity: Floats) -> bytes:
    """The bytes of a Neighbours message; `offset` and `velocity` (len(names), 3), see the message's own text."""
    body = struct.pack("<iI", *divmod(stamp_ns, NANOSECONDS)) + _text(frame) + struct.pack("<I", len(names))
    body += b"".join(_text(name) for name in names)
    for vectors in (offset, velocity):
        body += struct.pack("<I", len(names))
        if len(names):
            body += bytes(-len(body) % 8) + np.ascontiguousarray(vectors, dtype="<f8").tobytes()
    return ENCAPSULATION + body


def read_neighbours(data: bytes) -> tuple[tuple[str, ...], Floats, Floats]:
    """Names, offsets and velocities (n, 3) in the bytes of a Neighbours message. Raises CocorosimError."""
    message = type_store.deserialize(TYPE, data)
    return tuple(message.name), _vectors(message.offset), _vectors(message.velocity)


def _vectors(parts: Sequence[object]) -> Floats:
    rows = [[getattr(part, axis) for axis in "xyz"] for part in parts]
    return np.array(rows, dtype=np.float64).reshape(-1, 3)


def _text(text: str) -> bytes:
    """A string with its length before it, padded so that the next length can follow."""
    data = text.encode() + b"\x00"
    return struct.pack("<I", len(data)) + data + bytes(-len(data) % 4)
