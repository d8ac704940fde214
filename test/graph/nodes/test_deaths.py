"""Nodes that die, a disk that fills up, a supervisor that is killed: a sentence, a status, nothing left behind."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.wire.bags.bag_reader import read_bag

Starter = Callable[..., Any]
LIMIT = 200.0  # s; only a hang takes so long
ONLOOKER = Path(__file__).with_name("onlooker.py")
Counts = Callable[[Path], dict[str, int]]


@pytest.fixture
def held(start: Starter, paced: Starter, scenario: Callable[..., Path], tmp_path: Path) -> Any:
    """A run whose ticks 0 to 2 are done, and that waits in tick 3 for its external controller."""
    run = start("cocorosim", "run", scenario(2, 50), "--external", "lily_02", "--out", tmp_path / "run")
    pacer = paced(run, "lily_02")
    pacer.say("good", "good", "good")
    pacer.wait_for(r"tick 1\.5\n")
    assert set(run.find_nodes()) == {"physics_node", "metrics_node", "controller_lily_01"}
    return run


def test_nodes_have_their_names(held: Any, start: Starter) -> None:
    """A stranger on the graph sees the three kinds of nodes, the controller in its robot's namespace."""
    domain = held.wait_for(r"export ROS_DOMAIN_ID=(\d+)")[1]
    env = {"ROS_DOMAIN_ID": domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    names = ("/physics_node", "/metrics_node", "/lily_01/controller_node")
    assert start(ONLOOKER, "names", *names, env=env).finish() == 0


def test_processes_have_their_names(held: Any) -> None:
    """`ps -o comm` and `top` tell them apart: a robot's controller goes by the robot's name."""
    shown = {name: Path(f"/proc/{pid}/comm").read_text("utf-8").strip() for name, pid in held.nodes.items()}
    assert shown == {"physics_node": "physics_node", "metrics_node": "metrics_node", "controller_lily_01": "lily_01"}


def test_physics_node_dies(held: Any, counts: Counts, tmp_path: Path, all_ended: Callable[[Any], None]) -> None:
    """Status 1, who died and when, and a bag that is closed with the ticks that were done."""
    os.kill(held.nodes["physics_node"], signal.SIGKILL)
    assert held.finish() == 1, held.output
    assert "physics_node was ended by signal SIGKILL; 3 of 50 ticks were done." in held.output
    assert counts(tmp_path / "run" / "bag")["/shoal_statistics"] in (3, 4), "tick 3 was published, at least in part"
    all_ended(held)


def test_metrics_node_dies(held: Any, tmp_path: Path, all_ended: Callable[[Any], None]) -> None:
    """Status 1, and what it had written reads as not closed."""
    os.kill(held.nodes["metrics_node"], signal.SIGKILL)
    assert held.finish() == 1, held.output
    assert "metrics_node was ended by signal SIGKILL" in held.output
    assert read_bag(tmp_path / "run" / "bag").summary.damage
    all_ended(held)


def test_the_command_itself_is_killed(
    held: Any, counts: Counts, tmp_path: Path, all_ended: Callable[[Any], None]
) -> None:
    """Its nodes end with it, and the recorder closes the bag."""
    held.process.kill()
    all_ended(held)
    assert counts(tmp_path / "run" / "bag")["/shoal_statistics"] >= 3


def test_the_command_is_killed_while_a_controller_hangs(held: Any, all_ended: Callable[[Any], None]) -> None:
    """Even a stopped process does not outlive it."""
    os.kill(held.nodes["controller_lily_01"], signal.SIGSTOP)
    held.process.kill()
    all_ended(held)


def test_the_disk_is_full(tmp_path: Path) -> None:
    """Status 1 with the reason; what fits is kept and readable, and no node is left.

    The disk is one that takes files of 60 kB: writing on fails as it does where there is no room.
    """
    limit = 60_000
    command = [Path(sys.executable).parent / "cocorosim", "run", "eleven_lilys", "--out", tmp_path / "run"]
    done = subprocess.run(
        list(map(str, command)),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)),
        capture_output=True,
        text=True,
        timeout=LIMIT,
        check=False,
        env={**os.environ, "COLUMNS": "400"},
    )
    assert done.returncode == 1, done.stdout + done.stderr
    assert "cannot go on: File too large" in done.stderr
    assert "Traceback" not in done.stderr
    bag = read_bag(tmp_path / "run" / "bag")
    assert bag.summary.damage
    assert sum(1 for _ in bag.messages()) > 0
