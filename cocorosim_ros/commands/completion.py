"""What a shell offers behind the tab key: names that ship, and files, which do as well wherever a name does."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import click
from click.shell_completion import CompletionItem

from cocorosim_ros.scenario.reading.config_files import config_names

Complete = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]
SHELLS = ("bash", "zsh", "fish")
"""What click writes completions for."""


def config_or_file(kind: str) -> Complete:
    """The names of all shipped files of a kind, such as 'scenarios', and files."""

    def complete(ctx: click.Context, parameter: click.Parameter, typed: str) -> list[CompletionItem]:
        return [*_beginning(config_names(kind), typed), CompletionItem(typed, type="file")]

    return complete


def explained(ctx: click.Context, parameter: click.Parameter, typed: str) -> list[CompletionItem]:
    """The names of all effects, metrics, topics, controllers and keys, each with what it is."""
    from cocorosim_ros.library.explaining.index import every_explanation

    kinds = {each.name: each.kind for each in every_explanation()}
    return [CompletionItem(name, help=kind) for name, kind in kinds.items() if name.startswith(typed)]


def several_of(words: Iterable[str]) -> Complete:
    """Words of which several may be given, separated by commas."""

    def complete(ctx: click.Context, parameter: click.Parameter, typed: str) -> list[CompletionItem]:
        before, comma, last = typed.rpartition(",")
        return [CompletionItem(f"{before}{comma}{item.value}") for item in _beginning(words, last)]

    return complete


def _beginning(names: Iterable[str], typed: str) -> list[CompletionItem]:
    return [CompletionItem(name) for name in names if name.startswith(typed)]
