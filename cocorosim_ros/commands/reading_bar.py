"""The bar of a command that reads a long recording: how far it is, and the time left."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import AbstractContextManager
from types import TracebackType

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

SHOWN_AFTER = 1.0  # s; what is read by then needs no bar
SHOWN_EVERY = 0.1  # s


class ReadingBar(AbstractContextManager["ReadingBar"]):
    """The bar of all recordings that a command reads. Each pass through a file begins it anew."""

    def __init__(self, console: Console, clock: Callable[[], float] = time.monotonic) -> None:
        """`clock`: seconds, that of the machine unless something else is given."""
        self._clock, self._began, self._last_shown = clock, clock(), 0.0
        self._bar = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            TaskProgressColumn(),
            TextColumn("left"),
            TimeRemainingColumn(compact=True),
            console=console,
            transient=True,
            auto_refresh=False,
            disable=not console.is_terminal,
            get_time=clock,
        )
        self._task = self._bar.add_task("reading", total=None)
        self._done = 0

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._bar.stop()

    def watch(self, done: int, total: int) -> None:
        """Show that `done` bytes of `total` of a file are read."""
        if done < self._done:
            self._bar.reset(self._task, total=total)
        self._done = done
        now = self._clock()
        if now - self._began < SHOWN_AFTER or now - self._last_shown < SHOWN_EVERY:
            return
        self._last_shown = now
        self._bar.start()
        self._bar.update(self._task, completed=done, total=total, refresh=True)
