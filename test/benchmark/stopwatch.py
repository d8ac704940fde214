"""Where the processes of a graph spend their CPU time: chosen functions are timed in the processes themselves.

Every process writes into its own cells of shared memory, so that nothing has to be sent. Times are those of the
calling thread and of the function itself, without the timed functions that it calls.
"""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Callable, Sequence
from typing import Any


class Stopwatch:
    """CPU seconds per process and label."""

    def __init__(self, processes: Sequence[str], labels: Sequence[str]) -> None:
        self._rows = {name: row for row, name in enumerate(processes)}
        self._columns = {label: column for column, label in enumerate(labels)}
        self._cells = multiprocessing.get_context("fork").RawArray("d", len(processes) * len(labels))
        self._inner: list[float] = []
        self._row = (0, -1)  # process id, row of that process

    def time(self, owner: Any, attribute: str, label: str) -> None:
        """Replace a function of a class or a module by one that is timed."""
        setattr(owner, attribute, self.timed(getattr(owner, attribute), label))

    def timed(self, function: Callable[..., Any], label: str) -> Callable[..., Any]:
        """The function, timed."""

        def wrapper(*args: Any, **kwargs: Any) -> Any:
            self._inner.append(0.0)
            start = time.thread_time()
            try:
                return function(*args, **kwargs)
            finally:
                elapsed = time.thread_time() - start
                self._add(label, elapsed - self._inner.pop())
                if self._inner:
                    self._inner[-1] += elapsed

        return wrapper

    def seconds(self, process: str, label: str) -> float:
        """What was measured."""
        return float(self._cells[self._rows[process] * len(self._columns) + self._columns[label]])

    def _add(self, label: str, seconds: float) -> None:
        if self._row[0] != os.getpid():  # forked since
            self._row = (os.getpid(), self._rows.get(multiprocessing.current_process().name, -1))
        row = self._row[1]
        if row >= 0:
            self._cells[row * len(self._columns) + self._columns[label]] += seconds
