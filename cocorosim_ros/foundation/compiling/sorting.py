"""Sorting without branches on the numbers: which places are compared is laid down for each count of numbers.

What is to be sorted is in no order, so that a processor would guess half of the branches of a common sort wrong. And
with the same comparisons for all, four numbers (see compiling.four) are sorted in the time of one.
Source: D. E. Knuth, The Art of Computer Programming, volume 3, algorithm 5.2.2 M (merge exchange, after K. E. Batcher).
"""

from __future__ import annotations

from typing import Any

from cocorosim_ros.foundation.compiling.four import chosen
from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def ordered(one: Any, other: Any) -> tuple[Any, Any]:
    """The smaller of two numbers and the larger; of fours in each lane."""
    swapped = other < one
    return chosen(swapped, other, one), chosen(swapped, one, other)


def comparisons(count: int) -> list[tuple[int, int]]:
    """Which of `count` places are to be compared, one pair after the other, until all are in ascending order."""
    top = 1 << max((count - 1).bit_length() - 1, 0)
    pairs, half = [], top
    while half > 0:
        limit, offset, distance = top, 0, half
        while True:
            pairs += [(place, place + distance) for place in range(count - distance) if place & half == offset]
            if limit == half:
                break
            distance, limit, offset = limit - half, limit // 2, half
        half //= 2
    return pairs


def lines_that_sort(count: int) -> list[str]:
    """Text for `compile_lines` that makes `row_0`, `row_1`, ... the first `count` of `rows` in ascending order.

    It uses `ordered`. Written out, a few rows stay in registers, of many most do, and what leads to rows that are not
    used afterwards is left out by the compiler. In a loop over the comparisons each would wait for the memory.
    """
    names = [f"row_{place}" for place in range(count)]
    return [
        *(f"{name} = rows[{place}]" for place, name in enumerate(names)),
        *(f"{names[a]}, {names[b]} = ordered({names[a]}, {names[b]})" for a, b in comparisons(count)),
    ]
