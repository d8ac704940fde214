"""Work that is done for each of many by itself, in several threads where they are enough.

Nothing may depend on what is done for another one in the same work, so that neither the number of threads nor their
order changes a bit. Threads take one small part after the other: one whose processor others use as well does fewer.
The caller begins in front and the other threads at the end, so that from one work to the next each has most of what
it needs in its own caches.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from cocorosim_ros.foundation.compiling.stretch import Stretch
from cocorosim_ros.foundation.processors import processors

Work = Callable[[Stretch | None], object]


class SideBySide:
    """Does work for all of many."""

    def __init__(self, total: int, at_a_time: int) -> None:
        """So many at a time; as many as there are, or more: no threads."""
        self._parts = [Stretch(first, min(first + at_a_time, total)) for first in range(0, max(total, 1), at_a_time)]
        self._helpers = min(processors(), len(self._parts)) - 1
        # Threads come to life with the first work and end with this object.
        self._threads = ThreadPoolExecutor(self._helpers) if self._helpers > 0 else None

    @property
    def threaded(self) -> bool:
        """Whether several threads take part."""
        return self._threads is not None

    def do(self, work: Work) -> None:
        """Call `work` for all of them, part by part in any order; with None, which is all at once, without threads."""
        if self._threads is None:
            work(None)
            return
        left = deque(self._parts)
        helping = [self._threads.submit(_take_parts, work, left.pop) for _ in range(self._helpers)]
        _take_parts(work, left.popleft)
        for helper in helping:
            if not helper.cancel():  # else it has not begun, and nothing is left to do
                helper.result()


def _take_parts(work: Work, take: Callable[[], Stretch]) -> None:
    """Do one part after the other until none is left."""
    while True:
        try:
            part = take()
        except IndexError:
            return
        work(part)
