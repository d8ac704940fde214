"""`cocorosim convert`: other people's logs, tables or bags, into recordings of the contract."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console

if TYPE_CHECKING:
    from cocorosim_ros.library.convert import ConvertedRecording, TopicExtent

_MOST_SHOWN_IN_FULL = 3


@click.command("convert", short_help="other people's logs into the contract")
@click.argument("map_file", metavar="MAP.yaml")
@click.argument("source", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), required=True, help="the recording to make, a folder")
@click.option("--force", is_flag=True, help="replace a recording that is there")
def command(map_file: str, source: Path, out: Path, force: bool) -> None:
    """Convert SOURCE as MAP.yaml (a file, or a name in config/maps) says.

    SOURCE is a file or a folder of them: CSV, Parquet, npz, mat; or one log: a bag of ROS 1 or 2, a ULog, a DataFlash
    log, a tlog. If it holds several runs, each becomes a recording of its own below the folder given with --out.
    """
    from cocorosim_ros.library.convert import convert

    console = Console(highlight=False, soft_wrap=True, markup=False)
    with console.status("reading") as status:
        done = convert(map_file, source, out, force=force, progress=lambda run: status.update(f"reading {run}"))
    for made in done.recordings:
        _show(console, made, full=len(done.recordings) <= _MOST_SHOWN_IN_FULL)


def _show(console: Console, made: ConvertedRecording, *, full: bool) -> None:
    console.print(f"{made.folder}: {len(made.topics)} topics, {made.messages} messages, digest {made.digest}")
    if full:
        for extent in made.topics:
            console.print(f"  /{extent.robot}/{extent.topic}: {_words(extent)}")
    for sentence in made.findings:
        console.print(f"  {sentence}", style="yellow")


def _words(extent: TopicExtent) -> str:
    """How many messages, how long, how often, and the longest gap."""
    if extent.longest_gap is None:
        return "1 message"
    rate = "" if extent.rate is None else f", {extent.rate:.4g} Hz"
    return f"{extent.messages} messages in {extent.duration:.3f} s{rate}, longest gap {extent.longest_gap:.3g} s"
