"""Ticks by the wall clock: nobody is waited for, the last command holds, who is late is counted and named."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.tracks import read_poses

Starter = Callable[..., Any]


def test_the_last_command_holds_and_the_late_are_named(
    start: Starter,
    paced: Starter,
    scenario: Callable[..., Path],
    counts: Callable[[Path], dict[str, int]],
    tmp_path: Path,
) -> None:
    """A controller that commands half thrust once, and then is silent, drives its robot at half thrust to the end."""
    ticks = 80  # 40 s: from anywhere in the start box half thrust reaches no wall in that time
    run = start(
        "cocorosim", "run", scenario(2, ticks), "--external", "lily_02", "--rate", 10, "--out", tmp_path / "run"
    )
    controller = paced(run, "lily_02")
    controller.say("good")
    assert run.finish() == 0, run.output
    bag = tmp_path / "run" / "bag"
    found = counts(bag)
    assert found["/lily_02/thruster_command"] == 1
    assert found["/lily_01/pose"] == found["/lily_02/pose"] == found["/clock"] == found["/shoal_statistics"] == ticks
    late = re.search(r"lily_02: (\d+) of 80 answers came late or not at all", run.output)
    assert late is not None, run.output
    assert int(late[1]) >= ticks - 1
    # Half thrust: terminal speed is sqrt(0.005 N / 1.7778 kg/m) = 0.053 m/s.
    track = read_poses(read_bag(bag))["lily_02"]
    speed = [
        float(sum((b - a) ** 2 for a, b in zip(first, second, strict=True)) ** 0.5 / 0.5)
        for first, second in zip(track.position[:-1], track.position[1:], strict=True)
    ]
    assert abs(speed[-1] - 0.053) < 0.001


def test_the_rate_is_kept(start: Starter, scenario: Callable[..., Path], tmp_path: Path) -> None:
    """At half of real time, ticks of 0.5 s come every second, however busy the machine: never faster."""
    run = start("cocorosim", "run", scenario(1, 3), "--rate", 0.5, "--out", tmp_path / "run")
    assert run.finish() == 0, run.output
    factor = re.search(r"([\d.]+) x real time, after", run.output)
    assert factor is not None, run.output
    assert 0.05 < float(factor[1]) <= 0.55
