"""`cocorosim metrics`: shoaling statistics of any recording that has poses, without ROS."""

from __future__ import annotations

from pathlib import Path

import click

from cocorosim_ros.commands.compiling_words import compiling_told
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.reading_bar import ReadingBar
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.wire.bags.bag_reader import read_bag, recording_at


@with_examples("cocorosim metrics runs/one --all", "cocorosim metrics runs/one --interval '1 s' --picture one.png")
@click.command("metrics", short_help="shoaling statistics of any recording that has poses")
@click.argument("bag", type=click.Path(path_type=Path))
@json_option
@click.option("--all", "all_metrics", is_flag=True, help="show every variant, not only the paper's six")
@click.option("--interval", metavar="TIME", help="measure every TIME, such as '0.5 s', by interpolation")
@click.option("--picture", type=click.Path(path_type=Path), help="draw tracks and statistics into this PNG file")
@click.option("--force", is_flag=True, help="replace files that are there")
def command(
    bag: Path, json_file: Path | None, all_metrics: bool, interval: str | None, picture: Path | None, force: bool
) -> None:
    """Show the shoaling statistics of BAG (a rosbag2 folder, an .mcap file, or the folder of a run).

    Robots are the topics NAMESPACE/pose of type geometry_msgs/msg/PoseStamped; without any, topics of type
    nav_msgs/msg/Odometry, poses of any name, or moving frames in /tf. Where all robots have the same stamps, each stamp
    is a moment; otherwise poses are interpolated to common moments, gaps are left out, and both are said.
    """
    console = console_beside(json_file, force=force, inputs=[recording_at(bag)])
    check_file(picture, force=force, inputs=[recording_at(bag)])
    seconds = _seconds(interval)
    with ReadingBar(console) as bar:
        opened = read_bag(bag, bar.watch)
        # Loaded here: a path that is wrong is said before the weight comes.
        from cocorosim_ros.commands.show_results import metrics_table
        from cocorosim_ros.library.recording import Recording

        recording = Recording(opened)
        with compiling_told(console, "the statistics"):
            statistics = recording.measure(seconds)
    show_table(console, metrics_table(statistics, paper_only=not all_metrics))
    for sentence in statistics.findings:
        say(console, sentence, "yellow")
    give_json(console, json_file, statistics.tree())
    if picture is not None:
        recording.draw(picture, statistics, force=True)  # whether it may be written was asked before the work
        say(console, f"wrote {picture}")


def _seconds(interval: str | None) -> float | None:
    """The time that was typed."""
    from cocorosim_ros.scenario.reading.entry import Entry
    from cocorosim_ros.scenario.reading.quantity import read_nanoseconds
    from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

    if interval is None:
        return None
    return read_nanoseconds(Entry(interval, "the command line", 0, "--interval")) / NANOSECONDS
