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
from cocorosim_ros.foundation.counted import counted
from cocorosim_ros.foundation.errors import CocorosimError

if TYPE_CHECKING:
    from cocorosim_ros.library.convert import ConvertedRecording, TopicExtent

_MOST_SHOWN_IN_FULL = 3


@with_examples(
    "cocorosim convert odometry_bag drive --out recordings/drive",
    "cocorosim convert --guess drive --out drive.yaml",
)
@click.command("convert", short_help="other people's logs into the contract")
@click.argument("words", metavar="[MAP.yaml] SOURCE", nargs=-1, required=True, shell_complete=config_or_file("maps"))
@click.option("--guess", is_flag=True, help="write a map for SOURCE instead, as far as it can be told")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    required=True,
    help="the recording to make, a folder, or of several runs the folder of them all; of --guess the map",
)
@json_option
@click.option("--force", is_flag=True, help="replace what is there")
def command(words: tuple[str, ...], guess: bool, out: Path, json_file: Path | None, force: bool) -> None:
    """Convert SOURCE as MAP.yaml (a file, or a name in config/maps) says.

    SOURCE is a file or a folder of them: CSV, Parquet, npz, mat; or one log: a bag of ROS 1 or 2, a ULog, a DataFlash
    log, a tlog. If it holds one run, the folder given with --out is the recording; if it holds several, each becomes a
    recording of its own below it, OUT/RUN.

    With --guess and SOURCE alone, the map itself is written: what the topics or columns are by type, name, size and
    motion, with everything that is not sure in its comments. Look at these before the map is used.
    """
    if len(words) != 2 - guess:
        wanted = "SOURCE alone" if guess else "MAP.yaml and SOURCE, or --guess and SOURCE alone"
        raise CocorosimError(f"{len(words)} names were given; give {wanted}.")
    console = console_beside(json_file, force=force, inputs=map(Path, words))
    if guess:
        give_json(console, json_file, _guess(console, Path(words[0]), out, force=force))
        return
    from cocorosim_ros.library.convert import convert

    map_file, source = words[0], Path(words[1])
    with console.status("reading") as status:
        done = convert(map_file, source, out, force=force, progress=lambda run: status.update(f"reading {run}"))
    for made in done.recordings:
        _show(console, made, full=len(done.recordings) <= _MOST_SHOWN_IN_FULL)
    give_json(console, json_file, {"map": done.name, "recordings": [_tree(made) for made in done.recordings]})


def _guess(console: Console, source: Path, out: Path, *, force: bool) -> dict[str, Any]:
    """Write the map that a log most probably needs."""
    from cocorosim_ros.library.guess import guess

    with console.status("reading"):
        found = guess(source, out, force=force)
    for robot, topic, place in found.streams:
        say(console, f"/{robot}/{topic}: {place}")
    for sentence in found.doubts:
        say(console, f"  {sentence}", "yellow")
    say(console, f"wrote {out}; look at its comments, then: cocorosim convert {out} {source} --out recording")
    streams = [{"robot": robot, "topic": topic, "source": place} for robot, topic, place in found.streams]
    return {"map": str(out), "streams": streams, "doubts": list(found.doubts)}


def _show(console: Console, made: ConvertedRecording, *, full: bool) -> None:
    counts = f"{counted(len(made.topics), 'topic')}, {counted(made.messages, 'message')}"
    say(console, f"{made.folder}: {counts}, digest {made.digest}")
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
