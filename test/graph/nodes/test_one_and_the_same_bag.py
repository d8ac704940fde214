"""The same scenario and seed give the same bag: controllers each in a process or two in one, composed, without ROS."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.graph.nodes.ears import READERS_OF_ONE
from cocorosim_ros.graph.nodes.graph import PROCESSES
from cocorosim_ros.wire.bags.bag_reader import read_bag

ROBOTS, TICKS = 3, 20


@pytest.fixture
def run(start: Callable[..., Any], scenario: Callable[..., Path], tmp_path: Path) -> Callable[..., Path]:
    """Function of the options: the folder of a run."""

    def begin(name: str, *options: object) -> Path:
        folder = tmp_path / name
        process = start("cocorosim", "run", scenario(ROBOTS, TICKS), "--out", folder, *options)
        assert process.finish() == 0, process.output
        return folder

    return begin


def digest(folder: Path) -> str:
    """The digest that the recording carries."""
    return str(read_bag(folder / "bag").summary.metadata["cocorosim"]["digest"])


def test_every_way_of_running_gives_the_same_bag_and_the_same_numbers(
    run: Callable[..., Path], counts: Callable[[Path], dict[str, int]]
) -> None:
    """Digests, files and metrics.json are equal in all pairs, live numbers those of the bag; another seed differs."""
    graph, again = run("graph"), run("again", "--processes", 2)
    assert (again / "log" / "controller_lily_02_and_1_more.txt").exists(), "two controllers share a process"
    composed, alone = run("composed", "--composed"), run("alone", "--in-process")
    other = run("other", "--in-process", "--seed", 2)

    assert digest(again) == digest(graph)
    assert digest(composed) == digest(graph)
    assert digest(alone) == digest(graph)
    assert digest(other) != digest(graph)

    recordings = [folder / "bag" / "bag_0.mcap" for folder in (graph, again, composed, alone)]
    assert len({recording.read_bytes() for recording in recordings}) == 1

    text = (graph / "metrics.json").read_text()
    assert [(folder / "metrics.json").read_text() for folder in (again, composed, alone)] == [text] * 3
    live, of_bag = json.loads((graph / "live_metrics.json").read_text()), json.loads(text)
    assert live["metrics"] == of_bag["metrics"]
    assert live["ticks"] == of_bag["ticks"] == TICKS

    found = counts(graph / "bag")
    assert not [topic for topic in found if "_cocorosim" in topic]
    assert counts(alone / "bag") == found
    assert (graph / "shoal.png").read_bytes().startswith(b"\x89PNG")


def test_a_larger_swarm_shares_processes_and_participants(
    start: Callable[..., Any], scenario: Callable[..., Path], tmp_path: Path
) -> None:
    """More controllers than processes, more topics than one participant hears: the bag is that of a run without ROS."""
    robots, ticks = PROCESSES + 3, 6
    path, folders = scenario(robots, ticks), (tmp_path / "graph", tmp_path / "alone")
    for folder, options in zip(folders, ((), ("--in-process",)), strict=True):
        process = start("cocorosim", "run", path, "--out", folder, *options)
        assert process.finish() == 0, process.output
    graph, alone = folders
    assert len(list((graph / "log").glob("controller_*.txt"))) == PROCESSES
    assert len(read_bag(graph / "bag").summary.topics) > READERS_OF_ONE
    assert (graph / "bag" / "bag_0.mcap").read_bytes() == (alone / "bag" / "bag_0.mcap").read_bytes()
