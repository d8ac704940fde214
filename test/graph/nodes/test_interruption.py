"""Ctrl-C at any moment: the bag is closed and valid or was not begun, no process is left, the status is 130."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.wire.bags.bag_reader import read_bag

Starter = Callable[..., Any]


def check(run: Any, folder: Path, all_ended: Callable[[Any], None]) -> None:
    """Fail unless the run ended as an interrupted one should, or was done already."""
    status = run.finish()
    assert "Traceback" not in run.output, run.output
    all_ended(run)
    done = (folder / "metrics.json").exists() and "(interrupted)" not in run.output
    assert status == (0 if done else 130), (status, run.output)
    if (folder / "bag").exists():
        bag = read_bag(folder / "bag")
        assert not bag.summary.damage
        assert (folder / "bag" / "metadata.yaml").exists()


@pytest.mark.parametrize("delay", [0.0, 0.15, 0.3, 0.6])
def test_while_it_starts(
    start: Starter, scenario: Callable[..., Path], tmp_path: Path, all_ended: Callable[[Any], None], delay: float
) -> None:
    """Processes come up, find each other and wait for a controller that is not there: whatever is hit."""
    run = start("cocorosim", "run", scenario(3, 50), "--external", "lily_02", "--out", tmp_path / "run")
    run.wait_for("in lock-step")
    time.sleep(delay)
    run.find_nodes()
    run.interrupt()
    check(run, tmp_path / "run", all_ended)


def test_in_the_middle(
    start: Starter,
    paced: Starter,
    scenario: Callable[..., Path],
    counts: Callable[[Path], dict[str, int]],
    tmp_path: Path,
    all_ended: Callable[[Any], None],
) -> None:
    """What was done is recorded in whole ticks, measured and drawn."""
    run = start("cocorosim", "run", scenario(2, 50), "--external", "lily_02", "--out", tmp_path / "run")
    pacer = paced(run, "lily_02")
    pacer.say(*["good"] * 6)
    pacer.wait_for(r"tick 3\n")
    run.find_nodes()
    run.interrupt()
    check(run, tmp_path / "run", all_ended)
    assert "7 ticks, 3.5 s simulated" in run.output, run.output
    found = counts(tmp_path / "run" / "bag")
    assert found["/shoal_statistics"] == found["/lily_01/thruster_command"] == 7
    assert (tmp_path / "run" / "shoal.png").exists()


@pytest.mark.parametrize("mode", ["--composed", "--in-process"])
def test_without_processes(
    start: Starter, scenario: Callable[..., Path], tmp_path: Path, all_ended: Callable[[Any], None], mode: str
) -> None:
    """The same in one process, with ROS and without, as soon as something was recorded."""
    folder = tmp_path / "run"
    run = start("cocorosim", "run", scenario(3, 200_000), mode, "--out", folder)
    recording = folder / "bag" / "bag_0.mcap"
    deadline = time.monotonic() + 200.0  # s; only a hang takes so long
    while not (recording.exists() and recording.stat().st_size > 20_000):
        assert run.process.poll() is None, run.output
        assert time.monotonic() < deadline
        time.sleep(0.02)
    run.interrupt()
    check(run, folder, all_ended)
    assert "(interrupted)" in run.output
