"""`--json FILE` of every command that prints a table: the same for programs, into a file or to standard output."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click
from rich.console import Console

from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.json_file import json_text, write_json
from cocorosim_ros.foundation.output_file import check_file

STANDARD_OUTPUT = Path("-")
json_option = click.option(
    "--json",
    "json_file",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="write the same to this file for programs; -: to standard output, and nothing else there",
)


def console_beside(json_file: Path | None, *, force: bool = True, inputs: Iterable[Path] = ()) -> Console:
    """Where people's words go: to standard error if the JSON takes standard output.

    inputs: files and folders that are read. Raises CocorosimError if the JSON cannot be written into its file, or would
    replace one (without `force`) or an input.
    """
    to_stdout = json_file == STANDARD_OUTPUT
    check_file(None if to_stdout else json_file, force=force, inputs=inputs)
    return Console(stderr=to_stdout)


def give_json(console: Console, json_file: Path | None, tree: dict[str, Any]) -> None:
    """Write what was asked for, and say where; nothing where nothing was."""
    if json_file == STANDARD_OUTPUT:
        click.echo(json_text(tree), nl=False)
    elif json_file is not None:
        write_json(json_file, tree)
        say(console, f"wrote {json_file}")
