"""Robots of a recording beside each other: their tracks do not wait for one another."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Found = TypeVar("Found")
MOST = 8  # threads


def of_each_track(work: Callable[[int], Found], count: int) -> list[Found]:
    """What `work` returns for each of `count` tracks, in their order.

    One track is one thread's: its memory is not locked. Kernels let go of the interpreter, so that threads help. They
    live as long as this call, for a process that is forked later would wait for them forever.
    """
    if count < 2 or len(os.sched_getaffinity(0)) < 2:
        return [work(number) for number in range(count)]
    with ThreadPoolExecutor(min(count, MOST)) as threads:
        return list(threads.map(work, range(count)))
