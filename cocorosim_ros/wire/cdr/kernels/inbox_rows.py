"""An inbox's numbers without its texts: a controller needs what was said, not by whom."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.wire.cdr.alignment import BODY, LENGTH_BYTES, MALFORMED, NUMBER_BYTES, STAMP_BYTES
from cocorosim_ros.wire.cdr.kernels.places import Bytes, after_text, aligned_place, length_at
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, PAYLOAD_LIMIT


@kernel
def rows_of_inbox(data: Bytes, rows: Floats) -> int:
    """Write the payloads in the bytes of a RadioInbox, little endian, into `rows` (capacity, MESSAGE_SIZE).

    Returns how many there are, `capacity` at most, or MALFORMED where the bytes end too early. Of a payload the
    first PAYLOAD_LIMIT numbers are kept.
    """
    at = after_text(data, BODY + STAMP_BYTES)
    messages, at = length_at(data, at)
    for row in range(min(messages, rows.shape[0])):
        at = after_text(data, after_text(data, aligned_place(at, LENGTH_BYTES) + STAMP_BYTES))
        length, at = length_at(data, at)
        if length > 0:
            at = aligned_place(at, NUMBER_BYTES)
        if length == MALFORMED or at + NUMBER_BYTES * length > data.shape[0]:
            return MALFORMED
        kept = min(length, PAYLOAD_LIMIT)
        rows[row, MESSAGE_LENGTH] = kept
        for column in range(1, MESSAGE_SIZE):
            rows[row, column] = 0.0
        if kept > 0:
            numbers = data[at : at + NUMBER_BYTES * kept].view(np.float64)
            for column in range(kept):
                rows[row, 1 + column] = numbers[column]
        at += NUMBER_BYTES * length
    return int(min(messages, rows.shape[0]))  # MALFORMED, which is below, if there was no such number
