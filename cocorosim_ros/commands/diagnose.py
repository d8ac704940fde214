"""`cocorosim diagnose`: where recordings and the model of a platform disagree, why, and a model that does not."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, TypeVar, get_args

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from cocorosim_ros.commands.compiling_words import compiling_told
from cocorosim_ros.commands.completion import config_or_file, several_of
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.fleet import FleetChoices, check_fleet_options, diagnose_all
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.stage_lines import StageLines
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.diagnosis.findings import Verdict
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file, write_text
from cocorosim_ros.scenario.reading.entry import nearest

REFUSED = 3  # exit status
ShowProgress = Callable[[str, float], None]
_MOST_REMARKS = 8
_AGAINST = "--against"


@dataclass(frozen=True)
class DiagnosisChoices:
    """The options of one call."""

    bags: tuple[Path, ...]
    platform_name: str
    out: Path
    known: str | None
    against: tuple[Path, ...]
    fail_on: frozenset[Verdict]
    json_file: Path | None
    junit: Path | None
    markdown: Path | None
    force: bool


class _WithSeveral(click.Command):
    """Lets --against take several recordings, all up to the next option."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Write the option before each of its recordings. Raises CocorosimError if it has none."""
        spread: list[str] = []
        for word, following_word in zip(args, [*args[1:], "--"], strict=True):
            if word == _AGAINST and following_word.startswith("-"):
                raise CocorosimError(f"{_AGAINST} names no recording; give one or more of the sound vehicle after it.")
        following = False
        for word in args:
            if following and spread[-1] != _AGAINST and not word.startswith("-"):
                spread.append(_AGAINST)
            following = word == _AGAINST or (following and not word.startswith("-"))
            spread.append(word)
        return super().parse_args(ctx, spread)


_Choices = TypeVar("_Choices", DiagnosisChoices, FleetChoices)


@with_examples(
    "cocorosim diagnose runs/one --platform lily --out found",
    "cocorosim diagnose --fleet runs --platform lily --out found/all",
)
@click.command("diagnose", cls=_WithSeveral, short_help="where a recording and the model disagree, and why")
@click.argument("bags", metavar="BAG...", nargs=-1, type=click.Path(path_type=Path))
@click.option(
    "--platform",
    "platform_name",
    required=True,
    shell_complete=config_or_file("platforms"),
    help="name in config/platforms, or a file",
)
@click.option("--out", type=click.Path(path_type=Path), required=True, help="folder for the results")
@click.option(
    "--known",
    shell_complete=config_or_file("platforms"),
    help="platform file whose effects are taken as known",
)
@click.option(
    _AGAINST,
    metavar="GOOD...",
    multiple=True,
    type=click.Path(path_type=Path),
    help="recordings of the same vehicle when it was well: only what differs from these is named",
)
@click.option(
    "--fleet",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="diagnose every recording below this folder by itself, resumable, and say which robots drift",
)
@click.option("--workers", type=int, help="with --fleet: processes [default: one per processor]")
@click.option("--dask", metavar="SCHEDULER", help="with --fleet: diagnose on the workers of this Dask scheduler")
@click.option(
    "--fail-on",
    metavar="VERDICT,...",
    callback=lambda ctx, option, given: _verdicts(given),
    shell_complete=several_of(get_args(Verdict)),
    help=f"end with status 3 for these verdicts: {', '.join(get_args(Verdict))}",
)
@json_option
@click.option(
    "--junit",
    type=click.Path(path_type=Path),
    help="write the finding into this XML file as tests, which fail as --fail-on says [default: for mismatch]",
)
@click.option("--markdown", type=click.Path(path_type=Path), help="write the finding into this file as Markdown")
@click.option("--force", is_flag=True, help="replace results that are there")
@click.pass_context
def command(ctx: click.Context, /, **options: Any) -> None:
    """Compare recordings of robots of one platform, one BAG or several, with what the simulator makes of the commands.

    Writes report.html (to read), diagnosis.json (the same for programs) and model.yaml (a platform with what was
    found, for `cocorosim run` and for --platform of the next diagnosis). Where something is left open, also
    next_manoeuvre.yaml: a scenario for `cocorosim run` that drives what would show it. overlay/ is a bag on the
    recording's own clock, to open beside it in Foxglove or Lichtblick, or with `cocorosim view --3d BAG --against
    OUT/overlay`: ghosts of both models through the parts that no fit saw, residual forces, evidence over time.

    With --fleet DIR instead of BAG, every recording below DIR is diagnosed by itself. Writes fleet.parquet, a row for
    each robot and recording, and fleet.html: which robots drift, which recordings look alike, what is common to all.
    The same command goes on where it was interrupted or killed.
    """
    check_fleet_options(options)
    if options["fleet"] is not None:
        ctx.exit(diagnose_all(_chosen(FleetChoices, options)))
    from cocorosim_ros.library.diagnose import diagnose, inputs_of

    choices = _chosen(DiagnosisChoices, options)
    read = inputs_of((*choices.bags, *choices.against), choices.platform_name, choices.known)
    console = console_beside(choices.json_file, force=choices.force, inputs=read)
    for file in (choices.junit, choices.markdown):
        check_file(file, force=choices.force, inputs=read)
    with shown_progress(console) as show:
        result = diagnose(
            choices.bags,
            choices.platform_name,
            known=choices.known,
            against=choices.against or None,
            out=choices.out,
            force=choices.force,
            progress=show,
        )
    from cocorosim_ros.diagnosis.report.terminal_table import terminal_tables  # loads the compiler

    say(console, result.sentence, "bold")
    show_table(console, terminal_tables(result.diagnosis))
    _show_remarks(console, result.remarks)
    say(console, f"{choices.out}: {', '.join(reversed(list(result.files)))}")
    if result.overlay is not None:
        say(console, f"{choices.out / 'overlay'}: ghosts, residual forces and evidence, to open beside the recording")
    give_json(console, choices.json_file, result.tree)
    if choices.junit is not None:
        write_text(choices.junit, result.junit(choices.fail_on))
    if choices.markdown is not None:
        write_text(choices.markdown, result.markdown())
    if result.verdict in choices.fail_on:
        say(console, f"status {REFUSED}: --fail-on names the verdict {result.verdict}")
        ctx.exit(REFUSED)


def _chosen(kind: type[_Choices], options: dict[str, Any]) -> _Choices:
    """Those of the options that are of one kind of call."""
    return kind(**{field.name: options[field.name] for field in fields(kind)})


def _verdicts(given: str | None) -> frozenset[Verdict]:
    """The verdicts that were typed, separated by commas. Raises CocorosimError for one that there is not."""
    names = [name.strip() for name in given.split(",")] if given is not None else []
    every: tuple[Verdict, ...] = get_args(Verdict)
    for name in names:
        if name not in every:
            raise CocorosimError(f"--fail-on has '{name}', which is no verdict{nearest(name, every)}.")
    return frozenset(verdict for verdict in every if verdict in names)


def _show_remarks(console: Console, remarks: Sequence[str]) -> None:
    """What was odd about the recordings; what there is no room for stands in the report."""
    from cocorosim_ros.diagnosis.evidence.cleaning import is_noteworthy

    odd = [remark for remark in remarks if is_noteworthy(remark)]
    for remark in odd[:_MOST_REMARKS]:
        say(console, remark, "yellow")
    if odd[_MOST_REMARKS:]:
        say(console, f"{len(odd) - _MOST_REMARKS} more remarks are in report.html.", "yellow")


@contextmanager
def shown_progress(console: Console) -> Iterator[ShowProgress]:
    """A function of what is done and how much of all (0..1): on a terminal a bar with the time gone and left.

    Elsewhere a line each half minute says it on standard error, so that a file or pipe has results alone.
    From the first call on it is also said when functions are compiled.
    """
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    bar = Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
    with bar, ExitStack() as told:
        task = bar.add_task("", total=None)
        lines = None if console.is_terminal else told.enter_context(StageLines(Console(stderr=True)))

        def show(words: str, share: float) -> None:
            if bar.tasks[task].total is None:
                told.enter_context(compiling_told(console, "the diagnosis"))
            bar.update(task, description=words, completed=share, total=1.0)
            if lines is not None:
                lines.show(words, share)

        yield show
