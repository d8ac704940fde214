"""`cocorosim run`: a scenario as node graph, composed, or without ROS."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console

from cocorosim_ros.commands.completion import config_or_file
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.interruption import INTERRUPTED
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.errors import CocorosimError

if TYPE_CHECKING:
    from cocorosim_ros.commands.run_modes import Outcome, RunChoices
    from cocorosim_ros.scenario.scenario import Scenario

FAILED = 1
# OpenBLAS would start threads that a fork does not take along.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


@with_examples("cocorosim run eleven_lilys", "cocorosim run five_lilys --in-process --duration '60 s' --out runs/one")
@click.command(
    "run",
    short_help="run a scenario",
    epilog="Exit status: 0 the run was done; 1 it began and failed midway (what was recorded stays); 2 the input is "
    "unusable, nothing was touched; 130 interrupted by Ctrl-C or SIGTERM, the recording is complete until then.",
)
@click.argument("scenario", shell_complete=config_or_file("scenarios"))
@click.option("--out", type=click.Path(path_type=Path), help="folder of the run [default: runs/NAME]")
@click.option("--force", is_flag=True, help="replace a run that is there")
@click.option("--seed", type=int, help="seed instead of the scenario's own")
@click.option("--duration", help="length of the run, such as '60 s', instead of the scenario's own")
@click.option(
    "--external",
    multiple=True,
    metavar="ROBOT",
    help="leave the controller of this robot to you, or of all that fit a pattern such as 'lily_*' (repeatable)",
)
@click.option(
    "--controller",
    shell_complete=config_or_file("controllers"),
    help="for all robots instead of their own: a name, a file, or my_file.py:MyController",
)
@click.option("--wait", type=float, default=60.0, show_default=True, help="seconds that controllers get to appear")
@click.option("--rate", type=float, default=0.0, help="seconds of simulation per second; default: lock-step")
@click.option("--smooth", type=float, default=0.0, metavar="HZ", help="with --rate: /clock and /tf between ticks, too")
@click.option("--foxglove", type=int, metavar="PORT", help="show the run to Foxglove or Lichtblick; 0: any free port")
@click.option("--view", is_flag=True, help="show the run in three dimensions while it goes on; needs rerun-sdk")
@click.option(
    "--processes", type=int, metavar="N", help="of controllers at most [default: 12]; each has its own up to then"
)
@click.option("--composed", is_flag=True, help="all nodes in one process")
@click.option("--in-process", "in_process", is_flag=True, help="the same run without ROS")
@click.option("--network", is_flag=True, help="let other machines take part")
@json_option
@click.pass_context
def command(ctx: click.Context, /, **options: object) -> None:
    """Run SCENARIO (a name in config/scenarios, or a file) and leave a folder with bag, statistics and picture."""
    from cocorosim_ros.commands.run_folder import prepare_folder
    from cocorosim_ros.commands.run_modes import RunChoices, check_startable
    from cocorosim_ros.library.scenario import load_scenario

    choices = RunChoices(**options)  # type: ignore[arg-type]
    console = console_beside(choices.json_file, force=choices.force)
    scenario = load_scenario(
        choices.scenario,
        seed=choices.seed,
        duration=choices.duration,
        external=list(choices.external) or None,
        controller=choices.controller,
    )
    check_startable(scenario, choices)
    from cocorosim_ros.world.vehicle_model.platform_effects import not_simulated

    for sentence in not_simulated({robot.name: robot.platform for robot in scenario.robots}):
        console.print(sentence, style="yellow", markup=False, highlight=False)
    from cocorosim_ros.graph.runs.active_physics import active_physics

    say(console, active_physics(scenario))
    folder = prepare_folder(choices.out or Path("runs") / scenario.name, force=choices.force)
    try:
        outcome = _mode(choices)(scenario, choices, folder, console)
    except CocorosimError as error:
        click.echo(f"cocorosim: {error}{_what_is_left(folder)}", err=True)
        ctx.exit(FAILED)
    from cocorosim_ros.commands.show_results import show_results

    give_json(console, choices.json_file, show_results(console, scenario, folder, outcome))
    ctx.exit(INTERRUPTED if outcome.interrupted else 0)


def _mode(choices: RunChoices) -> Callable[[Scenario, RunChoices, Path, Console], Outcome]:
    """The function that does the run."""
    from cocorosim_ros.commands.run_modes import run_as_graph, run_in_one_process, run_without_ros

    if choices.in_process:
        return run_without_ros
    return run_in_one_process if choices.composed else run_as_graph


def _what_is_left(folder: Path) -> str:
    return f" What was recorded until then is in {folder / 'bag'}." if (folder / "bag").is_dir() else ""
