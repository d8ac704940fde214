"""`cocorosim check`: a first look at any robot's recording."""

from __future__ import annotations

from pathlib import Path

import click

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.counted import counted

FOUND = 1  # exit status


@with_examples("cocorosim check runs/one")
@click.command(
    "check",
    short_help="what is odd about any robot's recording, in seconds",
    epilog="Exit status: 0 nothing was found; 1 something was; 2 the recording cannot be read.",
)
@click.argument("bag", type=click.Path(path_type=Path))
@json_option
@click.option("--force", is_flag=True, help="replace a file that is there")
@click.pass_context
def command(ctx: click.Context, /, bag: Path, json_file: Path | None, force: bool) -> None:
    """Look at BAG, of whatever robot and messages (ROS 1 or 2), without a model, and say what is odd, a sentence each.

    Clocks that run backwards, stand at zero or differ; gaps and rates that drop; readings that stand still; transforms
    that contradict each other or lag, a lost /tf_static; covariances that are none; units, signs and axes that the
    numbers of Odometry, Imu, FluidPressure and poses contradict.
    """
    from cocorosim_ros.wire.bags.bag_reader import check_there, recording_at

    console = console_beside(json_file, force=force, inputs=[recording_at(bag)])
    check_there(bag)
    # Loaded here: a path that is wrong is said before the weight comes.
    from cocorosim_ros.library.check import check

    with console.status("reading"):
        checked = check(bag)
    for each in checked.findings:
        say(console, each.sentence, "yellow")
    messages = sum(count for _, _, count in checked.topics)
    found = counted(len(checked.findings), "finding") if checked.findings else "nothing odd was found"
    counts = f"{counted(len(checked.topics), 'topic')}, {counted(messages, 'message')}"
    say(console, f"{bag}: {counts}, {found}.")
    give_json(console, json_file, checked.tree())
    ctx.exit(FOUND if checked.findings else 0)
