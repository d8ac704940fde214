"""An inbox's numbers without its texts: a controller needs what was said, not by whom."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, PAYLOAD_LIMIT

Bytes = NDArray[np.uint8]

BODY = 4  # where a CDR body begins, behind its encapsulation header; alignment counts from here
STAMP = 8  # bytes
MALFORMED = -1


@kernel
def rows_of_inbox(data: Bytes, rows: Floats) -> int:
    """Write the payloads in the bytes of a RadioInbox, little endian, into `rows` (capacity, MESSAGE_SIZE).

    Returns how many there are, `capacity` at most, or MALFORMED where the bytes end too early. Of a payload the
    first PAYLOAD_LIMIT numbers are kept.
    """
    at = _after_text(data, BODY + STAMP)
    messages, at = _count(data, at)
    for row in range(min(messages, rows.shape[0])):
        at = _after_text(data, _after_text(data, _aligned(at, 4) + STAMP))
        length, at = _count(data, at)
        if length > 0:
            at = _aligned(at, 8)
        if length == MALFORMED or at + 8 * length > data.shape[0]:
            return MALFORMED
        kept = min(length, PAYLOAD_LIMIT)
        rows[row, MESSAGE_LENGTH] = kept
        for column in range(1, MESSAGE_SIZE):
            rows[row, column] = 0.0
        if kept > 0:
            numbers = data[at : at + 8 * kept].view(np.float64)
            for column in range(kept):
                rows[row, 1 + column] = numbers[column]
        at += 8 * length
    return int(min(messages, rows.shape[0]))  # MALFORMED, which is below, if there was no such number


@kernel
def _aligned(at: int, size: int) -> int:
    """The next place of numbers of `size` bytes."""
    return at + (BODY - at) % size


@kernel
def _count(data: Bytes, at: int) -> tuple[int, int]:
    """A length and where it ends; MALFORMED and the end of the data where it cannot be one."""
    at = _aligned(at, 4)
    if at + 4 > data.shape[0]:
        return MALFORMED, data.shape[0]
    value = np.int64(data[at : at + 4].view(np.uint32)[0])
    if value > data.shape[0]:
        return MALFORMED, data.shape[0]
    return int(value), at + 4


@kernel
def _after_text(data: Bytes, at: int) -> int:
    """Where the text that begins at `at` has ended; the end of the data where there is none."""
    length, at = _count(data, at)
    return int(min(at + max(length, 0), data.shape[0]))
