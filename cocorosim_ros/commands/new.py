"""`cocorosim new`: a commented file to begin with."""

from __future__ import annotations

from pathlib import Path

import click

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say

_KINDS = ("platform", "controller", "scenario", "map")
_NEXT = {
    "platform": "cocorosim diagnose {bag} --platform {file} --out found",
    "controller": "cocorosim run eleven_lilys --controller {file}:{name} --in-process",
    "scenario": "cocorosim run {file}",
    "map": "cocorosim convert {file} LOG --out bag",
}


@with_examples("cocorosim new platform my_robot", "cocorosim new platform my_robot --for recordings/drive")
@click.command("new", short_help="a commented file to begin with")
@click.argument("kind", metavar=f"[{'|'.join(_KINDS)}]", type=click.Choice(_KINDS))
@click.argument("name")
@click.option("--out", type=click.Path(path_type=Path), help="the file [default: NAME.yaml or NAME.py, here]")
@click.option(
    "--for",
    "recording",
    metavar="BAG",
    type=click.Path(path_type=Path),
    help="of a platform: a recording of the robot, which tells the names of its actuators, and its sensors",
)
@json_option
@click.option("--force", is_flag=True, help="replace files that are there")
def command(
    kind: str, name: str, out: Path | None, recording: Path | None, json_file: Path | None, force: bool
) -> None:
    """Write a commented platform, controller, scenario or map called NAME, which works as it is."""
    from cocorosim_ros.library.beginning import begin_file, class_name

    console = console_beside(json_file, force=force)
    file = begin_file(kind, name, out, recording=recording, force=force)
    following = _NEXT[kind].format(file=file, name=class_name(name), bag=recording or "BAG")
    say(console, f"wrote {file}; next:")
    say(console, f"  {following}")
    give_json(console, json_file, {"file": str(file), "next": following})
