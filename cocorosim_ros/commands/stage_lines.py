"""What long work is doing, in plain lines for where no terminal shows a bar: a log tells work from a standstill."""

from __future__ import annotations

import time
from contextlib import AbstractContextManager
from threading import Event, Thread
from types import TracebackType

from rich.console import Console

from cocorosim_ros.commands.terminal import say

SAID_EVERY = 30.0  # s; what is done by then needs no line


class StageLines(AbstractContextManager["StageLines"]):
    """Says time and again, until the work ends, which stage it is in; each stage may be longer than that time."""

    def __init__(self, console: Console, every: float = SAID_EVERY) -> None:
        """`every`: time from line to line [s]."""
        self._console, self._every, self._began = console, every, time.monotonic()
        self._stage: tuple[str, float] | None = None
        self._ended = Event()
        self._thread = Thread(target=self._say_again, daemon=True)

    def __enter__(self) -> StageLines:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._ended.set()
        self._thread.join()

    def show(self, words: str, share: float) -> None:
        """Keep in words what is being done now, and how much of all is done (0..1)."""
        self._stage = (words, share)

    def _say_again(self) -> None:
        while not self._ended.wait(self._every):
            if self._stage is not None:
                words, share = self._stage
                say(self._console, f"after {(time.monotonic() - self._began) / 60.0:.1f} min, {share:.0%}: {words}")
