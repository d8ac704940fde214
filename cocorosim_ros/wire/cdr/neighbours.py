"""The bytes of `neighbours`: how many there are changes from tick to tick, so the layout does too."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.alignment import NUMBER_BYTES
from cocorosim_ros.wire.cdr.primitives import ENCAPSULATION, pack_length, pack_stamp, pack_text, padding

TYPE = "cocorosim_msgs/msg/Neighbours"


def encode_neighbours(stamp_ns: int, frame: str, names: Sequence[str], offset: Floats, velocity: Floats) -> bytes:
    """The bytes of a Neighbours message; `offset` and `velocity` (len(names), 3), see the message's own text."""
    body = pack_stamp(stamp_ns) + pack_text(frame) + pack_length(len(names)) + b"".join(map(pack_text, names))
    for vectors in (offset, velocity):
        body += pack_length(len(names))
        if len(names):
            body += padding(len(body), NUMBER_BYTES) + np.ascontiguousarray(vectors, dtype="<f8").tobytes()
    return ENCAPSULATION + body


def read_neighbours(data: bytes) -> tuple[tuple[str, ...], Floats, Floats]:
    """Names, offsets and velocities (n, 3) in the bytes of a Neighbours message. Raises CocorosimError."""
    message = type_store.deserialize(TYPE, data)
    return tuple(message.name), _vectors(message.offset), _vectors(message.velocity)


def _vectors(parts: Sequence[object]) -> Floats:
    rows = [[getattr(part, axis) for axis in "xyz"] for part in parts]
    return np.array(rows, dtype=np.float64).reshape(-1, 3)
