"""Where the primitives of CDR stand: alignment for Python and for compiled functions, and how the latter find lengths.

Numbers are aligned to their own size, counted from the end of the encapsulation header (CORBA 3.3 part 2, 9.3; OMG
DDSI-RTPS 2.5, chapter 10).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.compiling.kernel import kernel

Bytes = NDArray[np.uint8]

BODY = 4  # where the body begins, behind the encapsulation header
LENGTH_BYTES = 4  # a uint32, before a text and before the elements of a list
STAMP_BYTES = 8  # seconds (int32), nanoseconds (uint32)
NUMBER_BYTES = 8  # a float64
MALFORMED = -1


def aligned(at: int, size: int) -> int:
    """The first place from `at` on where a number of `size` bytes may stand, counted from the encapsulation header."""
    return at + (BODY - at) % size


aligned_place = kernel(aligned)


@kernel
def length_at(data: Bytes, at: int) -> tuple[int, int]:
    """The length that stands at or behind `at`, and where it ends; MALFORMED and the end of the data without one."""
    at = aligned_place(at, LENGTH_BYTES)
    if at + LENGTH_BYTES > data.shape[0]:
        return MALFORMED, data.shape[0]
    value = np.int64(data[at : at + LENGTH_BYTES].view(np.uint32)[0])
    if value > data.shape[0]:
        return MALFORMED, data.shape[0]
    return int(value), at + LENGTH_BYTES


@kernel
def after_text(data: Bytes, at: int) -> int:
    """Where the text that begins at `at` has ended; the end of the data where there is none."""
    length, at = length_at(data, at)
    return int(min(at + max(length, 0), data.shape[0]))
