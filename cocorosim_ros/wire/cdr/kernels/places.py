"""How compiled functions find lengths and texts in CDR bytes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.wire.cdr.alignment import LENGTH_BYTES, MALFORMED, aligned

Bytes = NDArray[np.uint8]

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
