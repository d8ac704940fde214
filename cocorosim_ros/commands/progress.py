"""What a run shows while it runs: a bar, the real-time factor, late answers."""

from __future__ import annotations

import time
from collections.abc import Callable
from types import TracebackType

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from cocorosim_ros.scenario.scenario import Scenario

SHOWN_EVERY = 0.1  # s


class RunProgress:
    """A progress bar over the ticks of a scenario."""

    def __init__(self, console: Console, scenario: Scenario, complaint: Callable[[], str] = lambda: "") -> None:
        """complaint: asked now and then for a sentence that the user should read; "" for none."""
        self._scenario, self._console, self._complaint = scenario, console, complaint
        self._bar = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            TextColumn("{task.completed}/{task.total} ticks"),
            TextColumn("{task.fields[pace]}"),
            TimeRemainingColumn(),
            console=console,
            transient=not console.is_terminal,
            disable=not console.is_terminal,
        )
        self._task = self._bar.add_task(scenario.name, total=scenario.ticks, pace="")
        self._first: float | None = None
        self._last_shown = 0.0
        self._end = 0.0
        self.ticks = 0

    def __enter__(self) -> RunProgress:
        self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._tell_complaint()
        self._bar.stop()

    def show(self, ticks: int, missing_answers: int) -> None:
        """Show that `ticks` ticks are done and that so many answers were late or missing."""
        now = time.monotonic()
        if ticks > self.ticks:
            self._end = now
            if self._first is None:
                self._first = now
                self._ticks_at_first = ticks
        self.ticks = ticks
        if now - self._last_shown < SHOWN_EVERY and ticks < self._scenario.ticks:
            return
        self._last_shown = now
        self._tell_complaint()
        late = f", {missing_answers} answers late or missing" if missing_answers else ""
        self._bar.update(self._task, completed=ticks, pace=f"{self.factor():.1f} x real time{late}")

    def _tell_complaint(self) -> None:
        if words := self._complaint():
            self._console.print(words, style="yellow", markup=False, highlight=False)

    def factor(self) -> float:
        """Seconds of simulation per second of wall clock since the first tick seen."""
        if self._first is None or self._end <= self._first:
            return 0.0
        return (self.ticks - self._ticks_at_first) * self._scenario.tick / (self._end - self._first)

    @property
    def seconds(self) -> float:
        """Wall-clock seconds between the first and the last tick seen."""
        return max(0.0, self._end - (self._first or self._end))

    def starting_after(self, start: float) -> float:
        """Wall-clock seconds from `start` to the first tick seen."""
        return max(0.0, (self._first or start) - start)
