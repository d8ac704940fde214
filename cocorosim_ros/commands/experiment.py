"""`cocorosim experiment`: all runs of a design, resumed where they were left; or one of them as a recording."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Generator, Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TaskID,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

from cocorosim_ros.foundation.errors import CocorosimError

FAILED, INTERRUPTED = 1, 130
_SPEED_OVER = 3600.0  # s; rich's own 30 s hold no two chunks of a long design, and without two it knows no time left
Going = Callable[[], bool]
Calculate = Callable[[list[Any], Going], Generator[Any, None, None]]
# Workers and OpenBLAS would fight for the same processors.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


@click.command("experiment", short_help="many runs without ROS, resumable")
@click.argument("design")
@click.option("--out", type=click.Path(path_type=Path), required=True, help="folder of the results")
@click.option("--workers", type=int, help="processes [default: one per processor]")
@click.option("--dask", metavar="SCHEDULER", help="calculate on the workers of this Dask scheduler")
@click.option("--replicates", type=int, help="runs per group instead of the design's own")
@click.option("--group", "groups", multiple=True, help="only this group (repeatable)")
@click.option("--numerics", multiple=True, help="only these numerics (repeatable)")
@click.option("--controller", help="of all robots in every group: a name, a file, or my_file.py:MyController")
@click.option(
    "--row",
    type=int,
    help="run this row, counted from 0, again and record it as a bag in --out: the row of the table that --results "
    "names, or of one that was made with these --replicates (the design's own if left out), --group and --numerics",
)
@click.option("--results", type=click.Path(path_type=Path), help="with --row: folder of the experiment with the table")
@click.option("--force", is_flag=True, help="start again instead of resuming")
@click.pass_context
def command(ctx: click.Context, /, **options: Any) -> None:
    """Run DESIGN (a name in config/designs, or a file): groups x replicates, one row a run in a Parquet table."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.world.controllers.plain.faults import ControllerError
    from cocorosim_ros.world.controllers.plain.plain_controller import check_plain

    selection = (options["replicates"], options["groups"], options["numerics"], options["controller"])
    design = load_design(options["design"], *selection)
    if options["workers"] is not None and options["workers"] < 1:
        raise CocorosimError(f"--workers has {options['workers']}; give 1 or more.")
    for cell in design.cells:
        check_plain(cell.scenario.robots)
    console = Console()
    if options["row"] is None and options["results"]:
        raise CocorosimError("--results names the table whose row is to be recorded; give --row too.")
    run = _run_all if options["row"] is None else _record_row
    try:
        status = run(design, options, console)
    except ControllerError as error:
        click.echo(f"cocorosim: {error} What is finished is in {options['out']}.", err=True)
        status = FAILED
    ctx.exit(status)


def _run_all(design: Any, options: dict[str, Any], console: Console) -> int:
    with _calculator(options) as calculate:  # before the folder is made: a scheduler may not answer
        from cocorosim_ros.study.experiments.store import Store

        store = Store(options["out"], design, force=options["force"])
        began = time.monotonic()
        missing = _add_missing(store, design, calculate, console)
    if missing:
        console.print(f"Interrupted; {design.runs - missing} of {design.runs} runs are kept. The same command goes on.")
        return INTERRUPTED
    table = store.complete()
    console.print(f"{store.results}: {table.num_rows} rows, {time.monotonic() - began:.1f} s")
    _say_what_ran_away(table, design, console)
    console.print(f"cocorosim report {options['out']}   shows them")
    return 0


def _say_what_ran_away(table: Any, design: Any, console: Console) -> None:
    from cocorosim_ros.commands.terminal import say

    made = list(zip(*(table[column].to_pylist() for column in ("group", "numerics", "ticks")), strict=True))
    for cell in design.cells:
        ticks = [ticks for group, numerics, ticks in made if (group, numerics) == (cell.group, cell.numerics)]
        away = sum(count < cell.scenario.ticks for count in ticks)
        if away:
            told = f"{away} of {len(ticks)} runs of the group '{cell.group}', {cell.numerics} numerics, ran away"
            why = "forces or currents are too strong for the integrator's step. Their rows have no values"
            say(console, f"{told}: {why}; a shorter step in that group's change would keep them.", "yellow")


def _add_missing(store: Any, design: Any, calculate: Calculate, console: Console) -> int:
    """Calculate what is not there yet; how many runs are missing in the end, more than none after an interruption."""
    from cocorosim_ros.commands.interruption import Interruption
    from cocorosim_ros.study.experiments.rows import chunks

    left = list(chunks(design, store.done()))
    missing = sum(chunk.count for chunk in left)
    if missing < design.runs:
        console.print(f"{design.runs - missing} of {design.runs} runs are there already")
    bar, task = new_bar(console, design.name, design.runs, design.runs - missing)
    with Interruption() as interruption, bar:
        with closing(calculate(left, lambda: not interruption.happened)) as tables:
            for rows in tables:
                store.add(rows)
                bar.advance(task, rows.num_rows)
                missing -= rows.num_rows
    return missing


@contextmanager
def _calculator(options: dict[str, Any]) -> Iterator[Calculate]:
    """What calculates chunks, in this process, in several or on a cluster."""
    if options["dask"]:
        from cocorosim_ros.study.experiments.on_dask import connected, run_on_dask

        with connected(options["dask"]) as client:
            yield lambda left, going: run_on_dask(left, client, going)
    else:
        yield lambda left, going: _calculated_here(left, options["workers"], going)


def _calculated_here(left: list[Any], asked: int | None, going: Going) -> Generator[Any, None, None]:
    from cocorosim_ros.study.experiments import execution

    workers = min(asked or execution.usual_workers(), len(left))
    if workers <= 1:
        return execution.run_here(left, going)
    return execution.run_in_processes(left, workers, going)


def new_bar(
    console: Console, name: str, runs: int, done: int, clock: Callable[[], float] | None = None
) -> tuple[Progress, TaskID]:
    """A bar with the time left, `done` of so many `runs` behind it, and its task; `clock` [s] is the system's own."""
    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TextColumn("left"),
        TimeRemainingColumn(compact=True),
        console=console,
        transient=not console.is_terminal,
        disable=not console.is_terminal,
        speed_estimate_period=_SPEED_OVER,
        get_time=clock,
    )
    task = bar.add_task(name, total=runs, completed=done)
    bar.advance(task, 0)  # the speed counts from here, not from the first chunk that is finished
    return bar, task


def _record_row(design: Any, options: dict[str, Any], console: Console) -> int:
    """One run of the design again, with its bag, statistics and picture."""
    from cocorosim_ros.commands.interruption import Interruption
    from cocorosim_ros.commands.progress import RunProgress
    from cocorosim_ros.commands.run_folder import prepare_folder
    from cocorosim_ros.commands.run_modes import Outcome
    from cocorosim_ros.commands.show_results import show_results
    from cocorosim_ros.graph.runs.in_process import run_in_process
    from cocorosim_ros.graph.runs.results import recording_metadata
    from cocorosim_ros.graph.runs.run_record import RunRecord
    from cocorosim_ros.wire.topics.body import describe_body

    cell, replicate = _run_of_row(design, options, console)
    scenario = cell.scenario
    folder = prepare_folder(options["out"], force=options["force"])
    metadata = {**recording_metadata(scenario), "run": str(replicate), "group": cell.group, "numerics": cell.numerics}
    record = RunRecord(folder / "bag", [describe_body(robot) for robot in scenario.robots], metadata)
    start = time.monotonic()
    console.print(f"row {options['row']}: group {cell.group}, {cell.numerics} numerics, replicate {replicate}")
    with Interruption() as interruption, RunProgress(console, scenario) as progress, record.writer:

        def show(tick: int) -> bool:
            progress.show(tick, 0)
            return not interruption.happened

        ticks = run_in_process(scenario, record, show, replicate)
    outcome = Outcome(ticks, progress.seconds, progress.starting_after(start), interruption.happened)
    show_results(console, scenario, folder, outcome)
    return INTERRUPTED if outcome.interrupted else 0


def _run_of_row(design: Any, options: dict[str, Any], console: Console) -> tuple[Any, int]:
    """The cell and the replicate of a row of the table that the options tell."""
    from cocorosim_ros.commands.terminal import say
    from cocorosim_ros.study.experiments.code_version import version
    from cocorosim_ros.study.experiments.table_row import row_of_table

    row, folder = options["row"], options["results"]
    if folder is None:
        if options["replicates"] is None:
            told = f"Row {row} of a table with the design's own {design.replicates} runs in each group"
            say(console, f"{told}; name the folder of another one with --results.", "yellow")
        return design.cell_of_row(row)  # type: ignore[no-any-return]
    if options["replicates"] is not None or options["groups"] or options["numerics"]:
        raise CocorosimError("The table of --results tells its own; leave out --replicates, --group and --numerics.")
    found = row_of_table(design, folder, row)
    if found.version != version():
        words = f"Row {row} was made by version {found.version} of the program, this is {version()}"
        say(console, f"{words}: the recording may differ from it.", "yellow")
    return found.cell, found.replicate
