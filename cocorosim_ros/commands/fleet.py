"""`cocorosim diagnose --fleet`: every recording below a folder, resumable, as one table and one page."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from cocorosim_ros.commands.interruption import INTERRUPTED
from cocorosim_ros.commands.json_output import console_beside, give_json
from cocorosim_ros.commands.resumed_bar import ResumedBar
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file, write_text

if TYPE_CHECKING:
    from cocorosim_ros.library.fleet_result import FleetResult

_MOST_SENTENCES = 8


@dataclass(frozen=True)
class FleetChoices:
    """The options of one call."""

    fleet: Path
    platform_name: str
    out: Path
    known: str | None
    workers: int | None
    dask: str | None
    json_file: Path | None
    markdown: Path | None
    force: bool


def check_fleet_options(options: dict[str, Any]) -> None:
    """Raise CocorosimError for options of `diagnose` that say nothing together."""
    if options["fleet"] is None:
        _check_single(options)
    else:
        _check_many(options)


def _check_single(options: dict[str, Any]) -> None:
    for name in ("workers", "dask"):
        if options[name] is not None:
            raise CocorosimError(f"--{name} says what diagnoses the recordings of a fleet; give --fleet too.")
    if not options["bags"]:
        raise CocorosimError("Missing argument 'BAG...'; give recordings, or a folder of many with --fleet.")


def _check_many(options: dict[str, Any]) -> None:
    if options["bags"]:
        raise CocorosimError(
            f"--fleet takes every recording below {options['fleet']}, and {options['bags'][0]} was given beside it; "
            "leave one of them out."
        )
    for name in ("against", "fail_on", "junit"):
        if options[name]:
            raise CocorosimError(
                f"--{name.replace('_', '-')} is about one diagnosis, and --fleet makes many; leave one of them out."
            )
    if options["workers"] is not None and options["dask"] is not None:
        raise CocorosimError("--workers are processes here, --dask is a cluster; leave one of them out.")
    if options["workers"] is not None and options["workers"] < 1:
        raise CocorosimError(f"--workers has {options['workers']}; give 1 or more.")


def diagnose_all(choices: FleetChoices) -> int:
    """Diagnose what is not there yet of a fleet; the exit status."""
    from cocorosim_ros.library.design import Watch
    from cocorosim_ros.library.diagnose import inputs_of
    from cocorosim_ros.library.fleet import diagnose_fleet

    # As fleet.html, they are written anew each time: the same command goes on, and --force would begin again.
    read = inputs_of((), choices.platform_name, choices.known)
    console = console_beside(choices.json_file, force=True, inputs=read)
    check_file(choices.markdown, force=True, inputs=read)
    with ResumedBar(console, choices.fleet.name, "recordings") as bar:
        result = diagnose_fleet(
            choices.fleet,
            choices.platform_name,
            choices.out,
            known=choices.known,
            workers=choices.dask or choices.workers,
            force=choices.force,
            watch=Watch(bar.show, bar.going),
        )
    _show(console, result)
    give_json(console, choices.json_file, result.tree())
    if choices.markdown is not None:
        write_text(choices.markdown, result.markdown())
    if result.missing:
        there = result.found.recordings
        say(console, f"Interrupted; {there} of {there + result.missing} recordings are kept. The same command goes on.")
        return INTERRUPTED
    return 0


def _show(console: Console, result: FleetResult) -> None:
    """The sentence, what drifts, what could not be used, and where the files are."""
    say(console, result.sentence, "bold")
    card = result.card()
    if card.rows:
        table = Table(title="what drifts", title_justify="left")
        for heading in card.headings:
            table.add_column(heading)
        for row in card.rows:
            table.add_row(*map(Text, row))
        show_table(console, table)
    for sentence in card.remarks[:_MOST_SENTENCES]:
        say(console, sentence, "yellow")
    if card.remarks[_MOST_SENTENCES:]:
        say(console, f"{len(card.remarks) - _MOST_SENTENCES} more sentences are in {result.files[1].name}.", "yellow")
    say(console, f"{result.folder}: {', '.join(file.name for file in reversed(result.files))}")
