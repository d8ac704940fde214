"""`cocorosim convert`: other people's logs, tables or bags, into recordings of the contract."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console

from cocorosim_ros.commands.completion import config_or_file
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say

if TYPE_CHECKING:
    from cocorosim_ros.library.convert import ConvertedRecording, TopicExtent

_MOST_SHOWN_IN_FULL = 3


@with_examples("cocorosim convert odometry_bag drive --out recordings/drive")
@click.command("convert", short_help="other people's logs into the contract")
@click.argument("map_file", metavar="MAP.yaml", shell_complete=config_or_file("maps"))
@click.argument("source", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), required=True, help="the recording to make, a folder")
@json_option
@click.option("--force", is_flag=True, help="replace what is there")
def command(map_file: str, source: Path, out: Path, json_file: Path | None, force: bool) -> None:
    """Convert SOURCE as MAP.yaml (a file, or a name in config/maps) says.

    SOURCE is a file or a folder of them: CSV, Parquet, npz, mat; or one log: a bag of ROS 1 or 2, a ULog, a DataFlash
    log, a tlog. If it holds several runs, each becomes a recording of its own below the folder given with --out.
    """
    from cocorosim_ros.library.convert import convert

    console = console_beside(json_file, force=force)
    with console.status("reading") as status:
        done = convert(map_file, source, out, force=force, progress=lambda run: status.update(f"reading {run}"))
    for made in done.recordings:
        _show(console, made, full=len(done.recordings) <= _MOST_SHOWN_IN_FULL)
    give_json(console, json_file, {"map": done.name, "recordings": [_tree(made) for made in done.recordings]})


def _show(console: Console, made: ConvertedRecording, *, full: bool) -> None:
    say(console, f"{made.folder}: {len(made.topics)} topics, {made.messages} messages, digest {made.digest}")
    if full:
        for extent in made.topics:
            say(console, f"  /{extent.robot}/{extent.topic}: {_words(extent)}")
    for sentence in made.findings:
        say(console, f"  {sentence}", "yellow")


def _tree(made: ConvertedRecording) -> dict[str, Any]:
    topics = [asdict(extent) for extent in made.topics]
    return {"folder": str(made.folder), "digest": made.digest, "topics": topics, "findings": list(made.findings)}


def _words(extent: TopicExtent) -> str:
    """How many messages, how long, how often, and the longest gap."""
    if extent.longest_gap is None:
        return "1 message"
    rate = "" if extent.rate is None else f", {extent.rate:.4g} Hz"
    return f"{extent.messages} messages in {extent.duration:.3f} s{rate}, longest gap {extent.longest_gap:.3g} s"
