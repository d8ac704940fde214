"""Where the primitives of CDR stand: sizes and alignment, for Python and for compiled functions.

Numbers are aligned to their own size, counted from the end of the encapsulation header (CORBA 3.3 part 2, 9.3; OMG
DDSI-RTPS 2.5, chapter 10).
"""

from __future__ import annotations

BODY = 4  # where the body begins, behind the encapsulation header
LENGTH_BYTES = 4  # a uint32, before a text and before the elements of a list
STAMP_BYTES = 8  # seconds (int32), nanoseconds (uint32)
NUMBER_BYTES = 8  # a float64
MALFORMED = -1


def aligned(at: int, size: int) -> int:
    """The first place from `at` on where a number of `size` bytes may stand, counted from the encapsulation header."""
    return at + (BODY - at) % size
