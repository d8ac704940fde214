"""`cocorosim metrics`: shoaling statistics of any recording that has poses, without ROS."""

from __future__ import annotations

from pathlib import Path

import click
from rich.console import Console

from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.wire.bags.bag_reader import read_bag

STANDARD_OUTPUT = Path("-")


@click.command("metrics", short_help="shoaling statistics of any recording that has poses")
@click.argument("bag", type=click.Path(path_type=Path))
@click.option(
    "--json",
    "json_file",
    type=click.Path(path_type=Path),
    help="write the statistics to this file too; -: to standard output, and nothing else",
)
@click.option("--all", "all_metrics", is_flag=True, help="show every variant, not only the paper's six")
@click.option("--interval", metavar="TIME", help="measure every TIME, such as '0.5 s', by interpolation")
@click.option("--picture", type=click.Path(path_type=Path), help="draw tracks and statistics into this PNG file")
@click.option("--force", is_flag=True, help="replace files that are there")
def command(
    bag: Path, json_file: Path | None, all_metrics: bool, interval: str | None, picture: Path | None, force: bool
) -> None:
    """Show the shoaling statistics of BAG (a rosbag2 folder, an .mcap file, or the folder of a run).

    Robots are the topics NAMESPACE/pose of type geometry_msgs/msg/PoseStamped. Where all robots have the same stamps,
    each stamp is a moment; otherwise poses are interpolated to common moments, gaps are left out, and both are said.
    """
    to_stdout = json_file == STANDARD_OUTPUT
    console = Console(stderr=to_stdout)
    for file in (None if to_stdout else json_file, picture):
        check_file(file, force=force)
    seconds, opened = _seconds(interval), read_bag(bag)
    # Loaded here: a path that is wrong is said before the weight comes.
    from cocorosim_ros.commands.show_results import metrics_table
    from cocorosim_ros.graph.runs.results import json_text, write_json
    from cocorosim_ros.library.recording import Recording

    recording = Recording(opened)
    statistics = recording.measure(seconds)
    show_table(console, metrics_table(statistics, paper_only=not all_metrics))
    for sentence in statistics.findings:
        say(console, sentence, "yellow")
    if to_stdout:
        click.echo(json_text(statistics.tree()), nl=False)
    elif json_file is not None:
        write_json(json_file, statistics.tree())
        say(console, f"wrote {json_file}")
    if picture is not None:
        recording.draw(picture, statistics, force=True)  # whether it may be written was asked before the work
        say(console, f"wrote {picture}")


def _seconds(interval: str | None) -> float | None:
    """The time that was typed."""
    from cocorosim_ros.scenario.reading.entry import Entry
    from cocorosim_ros.scenario.reading.quantity import read_nanoseconds

    if interval is None:
        return None
    return read_nanoseconds(Entry(interval, "the command line", 0, "--interval")) / 1e9
