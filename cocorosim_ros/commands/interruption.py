"""Ctrl-C and SIGTERM as a question that a run asks, instead of an exception in the middle of a write."""

from __future__ import annotations

import signal
from collections.abc import Callable
from types import FrameType, TracebackType
from typing import Any

INTERRUPTED = 130
"""Exit status of a command that Ctrl-C or SIGTERM has ended in order: 128 and the number of SIGINT."""


class Interruption:
    """Within, SIGINT and SIGTERM are noted; `then` says what else to do."""

    def __init__(self) -> None:
        self.happened = False
        self._reaction: Callable[[], None] = lambda: None
        self._before: dict[int, Any] = {}

    def then(self, reaction: Callable[[], None]) -> None:
        """Call `reaction` at the signal, at once if it has come already."""
        self._reaction = reaction
        if self.happened:
            reaction()

    def __enter__(self) -> Interruption:
        for number in (signal.SIGINT, signal.SIGTERM):
            self._before[number] = signal.signal(number, self._note)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _note(self, number: int, frame: FrameType | None) -> None:
        self.happened = True
        self._reaction()
