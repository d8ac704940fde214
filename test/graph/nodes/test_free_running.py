"""Ticks by the wall clock: nobody is waited for, the last command holds for a while, the late are named."""

from __future__ import annotations

import os
import re
import signal
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
    """Within the patience, a controller that commands half thrust once, and is silent then, drives its robot so."""
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
    assert abs(speeds(bag, "lily_02")[-1] - 0.053) < 0.001


def speeds(bag: Path, robot: str) -> list[float]:
    """Its speed [m/s] from tick to tick."""
    track = read_poses(read_bag(bag))[robot]
    return [
        float(sum((b - a) ** 2 for a, b in zip(first, second, strict=True)) ** 0.5 / 0.5)
        for first, second in zip(track.position[:-1], track.position[1:], strict=True)
    ]


def test_a_silent_controller_loses_its_thrusters(
    begin: Starter, paced: Starter, diagnostics: Callable[[Path], list[tuple[str, str]]]
) -> None:
    """After the patience its last command no longer holds, the robot coasts, and this is said while the run goes on."""
    run, bag = begin(2, 100, "lily_02", options=("--rate", 10), patience=1)
    controller = paced(run, "lily_02")
    controller.say("good")
    said = run.wait_for(r"lily_02: no answer at tick (\d+), nothing was heard for 1 s: its thrusters are off")
    assert "came late or not at all" not in run.output, "the run has not ended yet"
    assert int(said[1]) >= 15, "1 s are 20 ticks; the first of them may have been answered late"
    assert run.finish() == 0, run.output
    said_of_it = [words for name, words in diagnostics(bag) if name == "cocorosim: lily_02"]
    assert any("nothing was heard for 1 s" in words for words in said_of_it)
    found = speeds(bag, "lily_02")
    # Half thrust for 10 s gives 0.05 m/s, and v(t) = v0 / (1 + k v0 t / m) leaves a third of that after 10 s without.
    assert max(found) > 0.04
    assert found[-1] < 0.02


def test_who_is_heard_again_drives_again(begin: Starter, paced: Starter) -> None:
    """The first command after the silence counts, and that is said."""
    run, bag = begin(1, 160, "lily_01", options=("--rate", 10), patience=1)
    controller = paced(run, "lily_01")
    controller.say("good")
    run.wait_for("lily_01: no answer at tick")
    controller.say("all")
    run.wait_for("lily_01: it is heard again: its commands count again")
    assert run.finish() == 0, run.output
    # Without thrust, 30 s after the first command, it would be at 0.01 m/s; near the end it may be at a wall.
    assert max(speeds(bag, "lily_01")[60:]) > 0.04


def test_a_dead_controller_loses_its_thrusters_at_once(begin: Starter, paced: Starter) -> None:
    """However long the patience; the others go on."""
    run, _ = begin(2, 100, "lily_02", options=("--rate", 10), patience=600)
    pacer = paced(run, "lily_02")
    pacer.say("all")
    pacer.wait_for(r"tick 2\n")
    os.kill(run.find_nodes()["controller_lily_01"], signal.SIGKILL)
    run.wait_for(r"lily_01: no answer at tick \d+, its controller has died: its thrusters are off")
    assert run.finish() == 0, run.output
    assert "lily_02: no answer" not in run.output


def test_the_run_ends_with_a_silent_controller_if_the_scenario_says_so(begin: Starter, paced: Starter) -> None:
    """stop: status 1 with the sentence."""
    run, _ = begin(2, 400, "lily_02", options=("--rate", 10), patience=1, silent="stop")
    paced(run, "lily_02").say("good")
    assert run.finish() == 1, run.output
    assert "The run ends: lily_02: no answer at tick" in run.output
    assert "'lockstep.silent_controller' is 'stop'" in run.output


def test_the_rate_is_kept(start: Starter, scenario: Callable[..., Path], tmp_path: Path) -> None:
    """At half of real time, ticks of 0.5 s come every second, however busy the machine: never faster."""
    run = start("cocorosim", "run", scenario(1, 3), "--rate", 0.5, "--out", tmp_path / "run")
    assert run.finish() == 0, run.output
    factor = re.search(r"([\d.]+) x real time, after", run.output)
    assert factor is not None, run.output
    assert 0.05 < float(factor[1]) <= 0.55
