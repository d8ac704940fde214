"""`cocorosim view`: a recording as a page that plays it in a browser, or in three dimensions."""

from __future__ import annotations

import tempfile
import webbrowser
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console

from cocorosim_ros.commands.compiling_words import compiling_told
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.reading_bar import ReadingBar
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag, recording_at

if TYPE_CHECKING:
    from cocorosim_ros.library.recording import Recording


@dataclass(frozen=True)
class _ViewChoices:
    """The options of one call."""

    bag: Path
    in_3d: bool
    against: Path | None
    out: Path | None
    no_open: bool
    json_file: Path | None
    force: bool

    def __post_init__(self) -> None:
        """Raise CocorosimError for options that contradict each other."""
        if self.against is not None and not self.in_3d:
            raise CocorosimError("--against shows two recordings side by side, in three dimensions only; add --3d.")


@with_examples("cocorosim view runs/one", "cocorosim view runs/one --out one.html --no-open")
@click.command("view", short_help="look at a recording: a page that plays it, or a 3-D scene")
@click.argument("bag", type=click.Path(path_type=Path))
@click.option("--3d", "in_3d", is_flag=True, help="a scene for Rerun (.rrd) instead of a page; needs rerun-sdk")
@click.option("--against", type=click.Path(path_type=Path), help="with --3d: another recording beside BAG")
@click.option("--out", type=click.Path(path_type=Path), help="the page or scene [default: a new temporary file]")
@click.option("--no-open", is_flag=True, help="write the file and open nothing")
@json_option
@click.option("--force", is_flag=True, help="replace files that are there")
def command(**options: object) -> None:
    """Show BAG (a rosbag2 folder, an .mcap file, or the folder of a run) in a browser: tracks, headings, tank, metrics.

    The page is one HTML file that needs nothing else and can be sent to others. Robots are the topics NAMESPACE/pose of
    type geometry_msgs/msg/PoseStamped; without any, nav_msgs/msg/Odometry, poses of any name, or moving frames in /tf.

    With --3d the file is a recording for Rerun (https://rerun.io): tank, bodies, thrusters, cones of the sensors, who
    hears whom, trails, shoals by colour, currents, and the metrics on the same time line.
    """
    choices = _ViewChoices(**options)  # type: ignore[arg-type]
    read = [recording_at(path) for path in (choices.bag, choices.against) if path is not None]
    console = console_beside(choices.json_file, force=choices.force, inputs=read)
    check_file(choices.out, force=choices.force, inputs=read)
    with ReadingBar(console) as bar:
        opened = [read_bag(path, bar.watch) for path in (choices.bag, choices.against) if path is not None]
        with compiling_told(console, "the statistics"):
            recordings = [_with_poses(each, in_memory=choices.in_3d) for each in opened]
            file = _written(recordings, choices)
    remarks = [sentence for recording in recordings for sentence in _remarks(recording)]
    for sentence in remarks:
        say(console, sentence, "yellow")
    say(console, f"wrote {file}, {file.stat().st_size / 1e6:.1f} MB")
    give_json(console, choices.json_file, {"file": str(file), "findings": remarks})
    if not choices.no_open:
        _open(console, file, in_3d=choices.in_3d)


def _open(console: Console, file: Path, *, in_3d: bool) -> None:
    if in_3d:
        from cocorosim_ros.commands.rerun_viewer import open_viewer

        if fault := open_viewer(file):
            say(console, fault, "yellow")
    elif not webbrowser.open(file.resolve().as_uri()):
        say(console, "no browser was found here; open the page in one")


def _with_poses(bag: Bag, *, in_memory: bool) -> Recording:
    from cocorosim_ros.graph.runs.results import no_poses
    from cocorosim_ros.library.recording import Recording

    recording = Recording(bag)
    tracks = recording.tracks if in_memory else recording.poses
    if not any(track.stamp_ns.size for track in tracks.values()):
        raise CocorosimError(no_poses(recording.bag, list(tracks)))
    return recording


def _remarks(recording: Recording) -> list[str]:
    """What is missing from the recording or cannot be read."""
    from cocorosim_ros.graph.runs.results import readable_scenario

    return [
        sentence
        for sentence in (recording.damage, recording.source_of_poses, readable_scenario(recording.bag)[1])
        if sentence
    ]


def _write_page(recording: Recording, file: Path) -> None:
    from cocorosim_ros.graph.runs.results import scenario_facts
    from cocorosim_ros.study.pictures.facts import MetricSeries
    from cocorosim_ros.study.pictures.player import page_pieces

    findings = _remarks(recording)
    series = None
    try:
        statistics = recording.measure()
        series = MetricSeries(statistics.stamp_ns, statistics.series)
    except CocorosimError as error:  # places alone can be looked at, too
        findings.append(str(error))
    pieces = page_pieces(recording.poses, scenario_facts(recording.bag), findings, series)
    with file.open("w", encoding="utf-8") as page:
        page.writelines(pieces)


def _written(recordings: Sequence[Recording], choices: _ViewChoices) -> Path:
    """The page or scene, written. Raises CocorosimError if it cannot be."""
    name, out = recordings[0].path.resolve().name, choices.out
    try:
        file = _temporary(f"cocorosim_{name}_", ".rrd" if choices.in_3d else ".html") if out is None else out
        if choices.in_3d:
            from cocorosim_ros.commands.rerun_viewer import write_scenes

            write_scenes(recordings, file)
        else:
            _write_page(recordings[0], file)
    except OSError as error:
        raise CocorosimError(f"{out or name} cannot be written: {error.strerror}; give a file with --out.") from error
    return file


def _temporary(prefix: str, ending: str) -> Path:
    """A file that nobody else has, in a folder of its own."""
    return Path(tempfile.mkdtemp(prefix=prefix)) / f"recording{ending}"
