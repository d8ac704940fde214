"""Work on several tracks at once, in threads."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from cocorosim_ros.foundation.processors import processors

Found = TypeVar("Found")
MOST = 8  # threads


def of_each_track(work: Callable[[int], Found], count: int) -> list[Found]:
    """Call `work` with the numbers 0 to `count` - 1 of tracks, in threads; return the results in the order of tracks.

    Each track is used by one thread only, because its caches have no lock. Compiled kernels let go of the interpreter,
    so that threads help. The threads end with this call: a process that is forked later would wait for them forever.
    """
    if count < 2 or processors() < 2:
        return [work(number) for number in range(count)]
    with ThreadPoolExecutor(min(count, MOST)) as threads:
        return list(threads.map(work, range(count)))
