"""`cocorosim diagnose`: where recordings and the model of a platform disagree, why, and a model that does not."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from cocorosim_ros.commands.terminal import say, show_table

if TYPE_CHECKING:
    from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
    from cocorosim_ros.diagnosis.findings import Diagnosis
    from cocorosim_ros.scenario.parts.platform import Platform

ShowProgress = Callable[[str, float], None]
_MOST_REMARKS = 8


@click.command("diagnose", short_help="where a recording and the model disagree, and why")
@click.argument("bags", metavar="BAG...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--platform", "platform_name", required=True, help="name in config/platforms, or a file")
@click.option("--out", type=click.Path(path_type=Path), required=True, help="folder for the results")
@click.option("--known", help="platform file whose effects are taken as known")
@click.option("--force", is_flag=True, help="replace results that are there")
def command(bags: tuple[Path, ...], platform_name: str, out: Path, known: str | None, force: bool) -> None:
    """Compare recordings of robots of one platform, one BAG or several, with what the simulator makes of the commands.

    Writes report.html (to read), diagnosis.json (the same for programs) and model.yaml (a platform with what was
    found, for `cocorosim run` and for --platform of the next diagnosis). Where something is left open, also
    next_manoeuvre.yaml: a scenario for `cocorosim run` that drives what would show it.
    """
    from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
    from cocorosim_ros.diagnosis.report.output_folder import check_folder, write_folder
    from cocorosim_ros.diagnosis.report.terminal_table import terminal_tables

    console = Console(highlight=False)
    check_folder(out, force=force)
    platform = _base(platform_name, known)
    with _progress(console) as show:
        show("reading", 0.0)
        evidence = gather_evidence(bags, platform)
        diagnosis = _diagnose(evidence, show)
        show("writing", 1.0)
        texts = _texts(diagnosis, evidence)
        write_folder(out, texts)
    say(console, diagnosis.sentence, "bold")
    show_table(console, terminal_tables(diagnosis))
    _show_remarks(console, diagnosis)
    say(console, f"{out}: {', '.join(reversed(texts))}")


def _base(name: str, known: str | None) -> Platform:
    """The platform, with the effects of another one taken as known."""
    from cocorosim_ros.scenario.parts.known_effects import knowing
    from cocorosim_ros.scenario.parts.platform import load_platform

    platform = load_platform(name)
    if known is None:
        return platform
    return knowing(platform, load_platform(known))


def _diagnose(evidence: Evidence, show: ShowProgress) -> Diagnosis:
    from cocorosim_ros.diagnosis.diagnose import diagnose

    return diagnose(evidence, show)


def _show_remarks(console: Console, diagnosis: Diagnosis) -> None:
    """What was odd about the recordings; what there is no room for stands in the report."""
    from cocorosim_ros.diagnosis.evidence.cleaning import is_noteworthy

    odd = [remark for remark in diagnosis.remarks if is_noteworthy(remark)]
    for remark in odd[:_MOST_REMARKS]:
        say(console, remark, "yellow")
    if odd[_MOST_REMARKS:]:
        say(console, f"{len(odd) - _MOST_REMARKS} more remarks are in report.html.", "yellow")


def _texts(diagnosis: Diagnosis, evidence: Evidence) -> dict[str, str]:
    """The files by name."""
    from cocorosim_ros.diagnosis.report.json_file import diagnosis_json
    from cocorosim_ros.diagnosis.report.model_file import Origin, model_yaml
    from cocorosim_ros.diagnosis.report.report import render_report

    recordings = tuple(recording.origin for recording in evidence.recordings)
    recorded = [robot.name for recording in evidence.recordings for robot in recording.robots]
    # Robots that could not be fitted at all say nothing about what the others have in common.
    fitted = [robot for found in diagnosis.all_recalibrated for robot in found.robots]
    robots = dict.fromkeys(fitted or recorded)
    duration = max(recording.duration for recording in evidence.recordings)
    origin = Origin(evidence.platform, recordings, tuple(robots), duration)
    return {
        **_next_manoeuvre(diagnosis, evidence.platform),
        "diagnosis.json": diagnosis_json(diagnosis),
        "model.yaml": model_yaml(diagnosis, origin),
        "report.html": render_report(diagnosis, origin),
    }


def _next_manoeuvre(diagnosis: Diagnosis, platform: Platform) -> dict[str, str]:
    """The first of the advised manoeuvres as a scenario, where there is one that the platform can be driven through."""
    from cocorosim_ros.diagnosis.report.manoeuvre_scenario import can_be_driven, scenario_of

    if not diagnosis.manoeuvres or not can_be_driven(platform):
        return {}
    return {"next_manoeuvre.yaml": scenario_of(diagnosis.manoeuvres[0], platform, "model.yaml")}


@contextmanager
def _progress(console: Console) -> Iterator[ShowProgress]:
    """A function of what is being done and how much of all is done (0..1), shown as a bar on a terminal."""
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        task = bar.add_task("", total=1.0)
        yield lambda words, share: bar.update(task, description=words, completed=share)
