"""Compiling once on a machine: of processes that begin together one compiles, and the others wait for what it makes.

A mark in the cache says that a part of the work was done with these very sources in this very case; then nothing is
locked. That a function is compiled is said when that happens and not before, because the cache may hold it.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO

from numba.core import event

from cocorosim_ros.foundation.compiling.cache import folder_of_text
from cocorosim_ros.foundation.compiling.cache_place import cache_base

if sys.platform != "win32":
    import fcntl

MARK = "compiled"
LOOK = 0.1  # s between two tries of a lock
SILENCE = 1.0  # s of waiting without a word
DURATION = "once per version, about a minute or two"
Tell = Callable[[str], None]


def compile_once(part: str, case: str, work: Callable[[], None], tell: Tell) -> None:
    """Do `work`, which calls every compiled function that a part needs; alone on this machine where that is new.

    part: what of a run this is, such as "physics"; other parts may be compiled at the same time. case: what decides
    which functions are called, such as a scenario's text. tell(sentence) is told that compiling begins, ends, or is
    waited for.
    """
    mark = folder_of_text(f"{part}: {case}", [Path(work.__code__.co_filename)]) / MARK
    if mark.exists():
        with _telling(part, tell):
            work()
        return
    with _alone(part, tell), _telling(part, tell):
        work()
        mark.touch()


def somebody_compiles() -> bool:
    """Whether a process on this machine compiles some part."""
    return any(_is_held(path) for path in cache_base().glob("compiling_*.lock"))


@contextmanager
def said_when_compiling(part: str, tell: Tell) -> Iterator[_FirstOfAll]:
    """Within, the first function that has to be compiled is told of; gives what knows whether one was."""
    listener = _FirstOfAll(lambda: tell(f"compiling {part} ({DURATION})"))
    with event.install_listener("numba:compile", listener):
        yield listener


@contextmanager
def _telling(part: str, tell: Tell) -> Iterator[None]:
    """Within, where the work is compiling alone, the first function is told of, and at the end how long all took."""
    start = time.monotonic()
    with said_when_compiling(part, tell) as listener:
        yield
    if listener.happened:
        tell(f"compiled {part} in {time.monotonic() - start:.0f} s")


class _FirstOfAll(event.Listener):  # type: ignore[misc]
    """Calls a function at the first event."""

    def __init__(self, call: Callable[[], None]) -> None:
        self.happened = False
        self._call = call

    def on_start(self, event: object) -> None:
        """A function that the cache does not hold is about to be compiled."""
        if not self.happened:
            self.happened = True
            self._call()

    def on_end(self, event: object) -> None:
        """It is done."""


@contextmanager
def _alone(part: str, tell: Tell) -> Iterator[None]:
    """Within, no other process compiles this part."""
    with (cache_base() / f"compiling_{part.replace(' ', '_')}.lock").open("a") as file:
        start, told = time.monotonic(), False
        while not _locked(file, shared=False):
            if not told and time.monotonic() - start > SILENCE:
                told = True
                tell(f"another process compiles {part}; waiting for it ({DURATION})")
            time.sleep(LOOK)
        yield


def _is_held(path: Path) -> bool:
    with path.open("a") as file:
        return not _locked(file, shared=True)


def _locked(file: IO[str], *, shared: bool) -> bool:
    """Whether the lock on a file is ours now, until the file is closed; always where the system has no such locks."""
    if sys.platform != "win32":
        try:
            fcntl.flock(file, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
    return True
