"""`cocorosim explain`: what a key, an effect, a metric, a topic or a controller means."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.table import Table
from rich.text import Text

from cocorosim_ros.commands.completion import explained
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say, show_table

if TYPE_CHECKING:
    from cocorosim_ros.library.explaining.explanation import Explanation

_MOST_IN_FULL = 4


@with_examples("cocorosim explain lockstep.patience", "cocorosim explain wall_effect", "cocorosim explain effects")
@click.command("explain", short_help="what a key, an effect, a metric, a topic or a controller means")
@click.argument("key", required=False, shell_complete=explained)
@json_option
@click.option("--force", is_flag=True, help="replace a file that is there")
def command(key: str | None, json_file: Path | None, force: bool) -> None:
    """Say of KEY what it means, its unit, range and default, where it stands with which source, and what uses it.

    KEY is a key of a scenario, a platform or a map (`lockstep.patience`, or its last word), an effect (`wall_effect`)
    or a number of it (`wall_effect.gain`), a metric, a topic, a controller or its parameter. `effects` lists
    the catalogue: every effect and error of a sensor that a platform file may have. Without KEY all are listed.
    """
    from cocorosim_ros.library.explain import explain
    from cocorosim_ros.library.explaining.index import every_explanation

    console = console_beside(json_file, force=force)
    found = every_explanation() if key is None else explain(key)
    few = key is not None and len(found) <= _MOST_IN_FULL
    in_full = [each for each in found if few or each.name == key]
    for each in in_full:
        _show(console, each)
    if len(in_full) < len(found):
        _list(console, [each for each in found if each not in in_full])
    give_json(console, json_file, {"explanations": [each.tree() for each in found]})


def _show(console: Console, each: Explanation) -> None:
    say(console, f"{each.name}, {each.kind}", "bold")
    say(console, f"  {each.meaning}")
    for name, words in each.facts.items():
        say(console, f"  {name}: {words}")
    if each.used_by:
        say(console, f"  used by: {', '.join(each.used_by)}")


def _list(console: Console, several: Sequence[Explanation]) -> None:
    table = Table(title_justify="left")
    for heading in ("name", "what it is", "meaning"):
        table.add_column(heading)
    for each in several:
        table.add_row(*(Text(words) for words in (each.name, each.kind, each.meaning)))
    show_table(console, table)
