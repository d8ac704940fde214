"""`cocorosim convert`: other people's logs, CSV files or bags, into recordings of the contract."""

from __future__ import annotations

from pathlib import Path

import click
from rich.console import Console

from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.assembly import Stream
from cocorosim_ros.wire.conversion.conversion import Converted, convert
from cocorosim_ros.wire.conversion.map_file import load_map

_MOST_SHOWN_IN_FULL = 3


@click.command("convert", short_help="other people's logs into the contract")
@click.argument("map_file", metavar="MAP.yaml")
@click.argument("source", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), required=True, help="the recording to make, a folder")
@click.option("--force", is_flag=True, help="replace a recording that is there")
def command(map_file: str, source: Path, out: Path, force: bool) -> None:
    """Convert SOURCE as MAP.yaml (a file, or a name in config/maps) says.

    SOURCE is a CSV file, a folder of them, or a bag. If it holds several runs, each becomes a recording of its own
    below the folder given with --out.
    """
    console = Console(highlight=False, soft_wrap=True, markup=False)
    mapped = load_map(find_config("maps", map_file))
    with console.status("reading") as status:
        done = convert(mapped, source, out, force=force, progress=lambda run: status.update(f"reading {run}"))
    for converted in done:
        _show(console, converted, full=len(done) <= _MOST_SHOWN_IN_FULL)


def _show(console: Console, converted: Converted, *, full: bool) -> None:
    conversion = converted.conversion
    count = sum(len(stream.stamp_ns) for stream in conversion.streams)
    console.print(f"{converted.folder}: {len(conversion.streams)} topics, {count} messages, digest {converted.digest}")
    if full:
        for stream in conversion.streams:
            console.print(f"  /{stream.robot}/{stream.topic}: {_extent(stream)}")
    for sentence in conversion.findings:
        console.print(f"  {sentence}", style="yellow")


def _extent(stream: Stream) -> str:
    """How many messages, how long, how often, and the longest gap."""
    stamps = stream.stamp_ns
    if len(stamps) < 2:
        return "1 message"
    steps = (stamps[1:] - stamps[:-1]) / 1e9
    span = (stamps[-1] - stamps[0]) / 1e9
    rate = f", {(len(stamps) - 1) / span:.4g} Hz" if span > 0 else ""
    return f"{len(stamps)} messages in {span:.3f} s{rate}, longest gap {steps.max():.3g} s"
