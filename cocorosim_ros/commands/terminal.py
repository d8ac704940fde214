"""Words and tables on the terminal, or in a pipe: sentences are never broken, tables never cut."""

from __future__ import annotations

from rich.console import Console, RenderableType
from rich.text import Text

_WIDE = 500  # columns, where there is no terminal


def say(console: Console, words: str, style: str = "") -> None:
    """Print a sentence as it is: brackets in file names are no markup."""
    console.print(Text(words, style=style), soft_wrap=True)


def show_table(console: Console, table: RenderableType) -> None:
    """Print a table or several, as wide as the terminal at most; into a pipe as wide as they are."""
    if not console.is_terminal:
        console = Console(file=console.file, width=_WIDE)
    console.print(table)
