"""The bar of work in many parts, some of which may be there from an earlier time."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import AbstractContextManager, ExitStack
from types import TracebackType

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TaskID,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

from cocorosim_ros.commands.interruption import Interruption

_SPEED_OVER = 3600.0  # s; rich's own 30 s hold no two parts of long work, and without two it knows no time left


class ResumedBar(AbstractContextManager["ResumedBar"]):
    """The bar of many things that are resumed, from when it is known how many are there.

    An interruption is noted from then on.
    """

    def __init__(self, console: Console, name: str, things: str) -> None:
        """`things`: what there are many of, in the plural."""
        self.began = time.monotonic()
        self._console, self._name, self._things = console, name, things
        self._interruption, self._open = Interruption(), ExitStack()
        self._shown: tuple[Progress, TaskID] | None = None
        self._done = 0

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._open.close()

    def going(self) -> bool:
        """Whether nobody has interrupted it."""
        return not self._interruption.happened

    def show(self, done: int, all_of_them: int) -> None:
        """Show that so many of all are there."""
        if self._shown is None:
            self._shown = self._begin(done, all_of_them)
        else:
            bar, task = self._shown
            bar.advance(task, done - self._done)
        self._done = done

    def _begin(self, done: int, all_of_them: int) -> tuple[Progress, TaskID]:
        self.began = time.monotonic()
        if done:
            self._console.print(f"{done} of {all_of_them} {self._things} are there already")
        bar, task = new_bar(self._console, self._name, all_of_them, done)
        self._open.enter_context(self._interruption)
        self._open.enter_context(bar)
        return bar, task


def new_bar(
    console: Console, name: str, total: int, done: int, clock: Callable[[], float] | None = None
) -> tuple[Progress, TaskID]:
    """A bar with the time left, `done` of `total` behind it, and its task; `clock` [s] is the system's own."""
    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(compact=True),
        console=console,
        transient=not console.is_terminal,
        disable=not console.is_terminal,
        speed_estimate_period=_SPEED_OVER,
        get_time=clock,
    )
    task = bar.add_task(name, total=total, completed=done)
    bar.advance(task, 0)  # the speed counts from here, not from the first chunk that is finished
    return bar, task
