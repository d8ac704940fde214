"""Lines to type, at the end of a command's help."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import click

_HEADING = "Examples:"
_Command = TypeVar("_Command", bound=click.Command)


def with_examples(*lines: str) -> Callable[[_Command], _Command]:
    """Puts lines, such as "cocorosim digest runs/one", below the help of the command that it decorates."""

    def add(command: _Command) -> _Command:
        # click leaves the lines of a paragraph that begins with \b as they are.
        below = "\n\n".join(["\b\n" + "\n".join([_HEADING, *(f"  {line}" for line in lines)]), command.epilog or ""])
        command.epilog = below.rstrip()
        return command

    return add


def examples_of(command: click.Command) -> list[str]:
    """The lines that the help of a command shows."""
    paragraph = (command.epilog or "").split("\n\n", maxsplit=1)[0].splitlines()
    return [line.strip() for line in paragraph[2:]] if _HEADING in paragraph else []
