"""Work on several tracks at once, and on several numbers of one track, in threads."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from cocorosim_ros.foundation.processors import processors

Found = TypeVar("Found")
MOST = 8  # threads


def of_each_track(work: Callable[[int], Found], count: int) -> list[Found]:
    """Call `work` with the numbers 0 to `count` - 1 of tracks, in threads; return the results in the order of tracks.

    Compiled kernels let go of the interpreter, so that threads help. More threads than processors share these evenly.
    """
    return _in_threads(work, count, min(count, MOST) if processors() > 1 else 1)


def of_each_number(work: Callable[[int], Found], count: int, tracks: int) -> list[Found]:
    """Call `work` with the numbers 0 to `count` - 1 of fitted numbers of one track; return the results in this order.

    In threads where there are more processors than `tracks`, each of which asks for this at the same time: a diagnosis
    of a single recording, too, has work for all of them. No result may depend on another one of the same call.
    """
    return _in_threads(work, count, min(count, -(-min(processors(), MOST) // tracks)))


def _in_threads(work: Callable[[int], Found], count: int, most: int) -> list[Found]:
    """Call `work` in at most so many threads, which end with this call: a process forked later would wait for them."""
    if min(count, most) < 2:
        return [work(number) for number in range(count)]
    with ThreadPoolExecutor(most) as threads:
        return list(threads.map(work, range(count)))
