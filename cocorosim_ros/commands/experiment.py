"""`cocorosim experiment`: all runs of a design, resumed where they were left; or one of them as a recording."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console

from cocorosim_ros.commands.completion import config_or_file
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.interruption import INTERRUPTED
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.resumed_bar import ResumedBar
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.errors import CocorosimError

if TYPE_CHECKING:
    from cocorosim_ros.study.experiments.design import Cell, Design

FAILED = 1
# Workers and OpenBLAS would fight for the same processors.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


@with_examples("cocorosim experiment smoke --replicates 2 --out results/smoke")
@click.command("experiment", short_help="many runs without ROS, resumable")
@click.argument("design", shell_complete=config_or_file("designs"))
@click.option("--out", type=click.Path(path_type=Path), required=True, help="folder of the results")
@click.option("--workers", type=int, help="processes [default: one per processor]")
@click.option("--dask", metavar="SCHEDULER", help="calculate on the workers of this Dask scheduler")
@click.option("--replicates", type=int, help="runs per group instead of the design's own")
@click.option("--group", "groups", multiple=True, help="only this group (repeatable)")
@click.option(
    "--numerics", multiple=True, shell_complete=config_or_file("numerics"), help="only these numerics (repeatable)"
)
@click.option(
    "--controller",
    shell_complete=config_or_file("controllers"),
    help="of all robots in every group: a name, a file, or my_file.py:MyController",
)
@click.option(
    "--row",
    type=int,
    help="run this row, counted from 0, again and record it as a bag in --out: the row of the table that --results "
    "names, or of one that was made with these --replicates (the design's own if left out), --group and --numerics",
)
@click.option("--results", type=click.Path(path_type=Path), help="with --row: folder of the experiment with the table")
@json_option
@click.option("--force", is_flag=True, help="start again instead of resuming")
@click.pass_context
def command(ctx: click.Context, /, **options: Any) -> None:
    """Run DESIGN (a name in config/designs, or a file): groups x replicates, one row a run in a Parquet table."""
    from cocorosim_ros.scenario.reading.config_files import find_config
    from cocorosim_ros.scenario.reading.yaml_file import load_yaml

    load_yaml(find_config("designs", options["design"]))  # what is no file of YAML is said before the weight comes
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.world.controllers.plain.faults import ControllerError
    from cocorosim_ros.world.controllers.plain.plain_controller import check_plain

    selection = (options["replicates"], options["groups"], options["numerics"], options["controller"])
    design = load_design(options["design"], *selection)
    check_workers(options["workers"])
    for cell in design.cells:
        check_plain(cell.scenario.robots)
    console = console_beside(options["json_file"], force=options["force"])
    if options["row"] is None and options["results"]:
        raise CocorosimError("--results names the table whose row is to be recorded; give --row too.")
    try:
        if options["row"] is None:
            kept = Kept(options["out"], options["dask"] or options["workers"], options["force"])
            status, tree = run_all(design, kept, console)
        else:
            status, tree = _record_row(design, options, console)
        give_json(console, options["json_file"], tree)
    except ControllerError as error:
        click.echo(f"cocorosim: {error} What is finished is in {options['out']}.", err=True)
        status = FAILED
    ctx.exit(status)


def check_workers(workers: int | None) -> None:
    """Raise CocorosimError for a number of processes that is none."""
    if workers is not None and workers < 1:
        raise CocorosimError(f"--workers has {workers}; give 1 or more.")


@dataclass(frozen=True)
class Kept:
    """Where the rows of a design are kept, what calculates them (as in `run_design`), and whether it starts again."""

    out: Path
    workers: int | str | None = None
    force: bool = False


def run_all(design: Design, kept: Kept, console: Console) -> tuple[int, dict[str, Any]]:
    """Run what is not there yet of a design; the exit status, and the results for programs."""
    from cocorosim_ros.library.design import Watch, run_design

    with ResumedBar(console, design.name, "runs") as bar:
        watch = Watch(bar.show, bar.going)
        results = run_design(design, kept.out, workers=kept.workers, force=kept.force, watch=watch)
    if results.missing:
        there = design.runs - results.missing
        console.print(f"Interrupted; {there} of {design.runs} runs are kept. The same command goes on.")
        return INTERRUPTED, results.tree()
    console.print(f"{results.file}: {results.table.num_rows} rows, {time.monotonic() - bar.began:.1f} s")
    for sentence in results.findings:
        say(console, sentence, "yellow")
    console.print(f"cocorosim report {kept.out}   shows them")
    return 0, results.tree()


def _record_row(design: Design, options: dict[str, Any], console: Console) -> tuple[int, dict[str, Any]]:
    """One run of the design again, with its bag, statistics and picture."""
    from cocorosim_ros.commands.interruption import Interruption
    from cocorosim_ros.commands.progress import RunProgress
    from cocorosim_ros.commands.run_folder import prepare_folder
    from cocorosim_ros.commands.run_modes import Outcome
    from cocorosim_ros.commands.show_results import show_results
    from cocorosim_ros.graph.runs.in_process import run_in_process
    from cocorosim_ros.library.record import new_record
    from cocorosim_ros.world.controllers.plain.plain_controller import rehearse_plain

    cell, replicate = _run_of_row(design, options, console)
    scenario = cell.scenario
    rehearse_plain(scenario.robots, scenario.seed, replicate)
    folder = prepare_folder(options["out"], force=options["force"])
    made_by = {"run": str(replicate), "group": cell.group, "numerics": cell.numerics}
    record = new_record(scenario, folder / "bag", made_by=made_by)
    start = time.monotonic()
    console.print(f"row {options['row']}: group {cell.group}, {cell.numerics} numerics, replicate {replicate}")
    with Interruption() as interruption, RunProgress(console, scenario) as progress, record.writer:

        def show(tick: int) -> bool:
            progress.show(tick, 0)
            return not interruption.happened

        ticks = run_in_process(scenario, record, show, replicate)
    outcome = Outcome(ticks, progress.seconds, progress.starting_after(start), interruption.happened)
    tree = {**made_by, **show_results(console, scenario, folder, outcome)}
    return INTERRUPTED if outcome.interrupted else 0, tree


def _run_of_row(design: Design, options: dict[str, Any], console: Console) -> tuple[Cell, int]:
    """The cell and the replicate of a row of the table that the options tell."""
    from cocorosim_ros.study.experiments.code_version import version
    from cocorosim_ros.study.experiments.table_row import row_of_table

    row, folder = options["row"], options["results"]
    if folder is None:
        if options["replicates"] is None:
            told = f"Row {row} of a table with the design's own {design.replicates} runs in each group"
            say(console, f"{told}; name the folder of another one with --results.", "yellow")
        return design.cell_of_row(row)
    if options["replicates"] is not None or options["groups"] or options["numerics"]:
        raise CocorosimError("The table of --results tells its own; leave out --replicates, --group and --numerics.")
    found = row_of_table(design, folder, row)
    if found.version != version():
        words = f"Row {row} was made by version {found.version} of the program, this is {version()}"
        say(console, f"{words}: the recording may differ from it.", "yellow")
    return found.cell, found.replicate
