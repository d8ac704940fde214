"""`cocorosim view`: a recording as a page that plays it in a browser."""

from __future__ import annotations

import tempfile
import webbrowser
from pathlib import Path

import click
from rich.console import Console

from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.graph.runs.results import no_poses, scenario_facts
from cocorosim_ros.study.pictures.player import player_page
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.tracks import read_poses


@click.command("view", short_help="look at a recording: a page that plays it")
@click.argument("bag", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), help="the page [default: a new temporary file]")
@click.option("--no-open", is_flag=True, help="write the page and open no browser")
@click.option("--force", is_flag=True, help="replace a page that is there")
def command(bag: Path, out: Path | None, no_open: bool, force: bool) -> None:
    """Show BAG (a rosbag2 folder, an .mcap file, or the folder of a run) in a browser: tracks, headings, tank, time.

    The page is one HTML file that needs nothing else and can be sent to others. Robots are the topics NAMESPACE/pose of
    type geometry_msgs/msg/PoseStamped.
    """
    console = Console()
    check_file(out, force=force)
    opened = read_bag(bag)
    tracks = read_poses(opened)
    if not any(track.stamp_ns.size for track in tracks.values()):
        raise CocorosimError(no_poses(opened, list(tracks)))
    findings = [opened.summary.damage] if opened.summary.damage else []
    page = _written(player_page(tracks, scenario_facts(opened), findings), out, opened.path.resolve().name)
    for sentence in findings:
        say(console, sentence, "yellow")
    say(console, f"wrote {page}, {page.stat().st_size / 1e6:.1f} MB")
    if not no_open and not webbrowser.open(page.resolve().as_uri()):
        say(console, "no browser was found here; open the page in one")


def _written(text: str, out: Path | None, name: str) -> Path:
    """The file that the page is in. Raises CocorosimError if it cannot be written."""
    try:
        if out is None:
            with tempfile.NamedTemporaryFile(prefix=f"cocorosim_{name}_", suffix=".html", delete=False) as file:
                out = Path(file.name)
        out.write_text(text, "utf-8")
    except OSError as error:
        raise CocorosimError(f"{out or name} cannot be written: {error.strerror}; give a file with --out.") from error
    return out
