"""What a command says while functions are compiled, which takes a minute or two once per version."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console

from cocorosim_ros.commands.terminal import say


@contextmanager
def compiling_told(console: Console, part: str) -> Iterator[None]:
    """Within, which is work as well, a sentence says that `part` is being compiled; none if nothing is."""
    from cocorosim_ros.foundation.compiling.once import said_when_compiling  # loads the compiler

    with said_when_compiling(part, lambda words: say(console, words)):
        yield
