"""Runs of the command and of the nodes as processes, watched by what they print and write."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

LIMIT = 200.0  # s; only a hang takes so long
PATIENCE = 20.0  # s that a process gets to end by itself
BIN = Path(sys.executable).parent
PACED = Path(__file__).with_name("paced_controller.py")
SCENARIO = """
name: small
description: a few Lilys for a few ticks
seed: {seed}
tick: 0.5 s
duration: {duration} s
tank: {{size: [6 m, 6 m, 2 m]}}
integrator: {{name: rk4, step: 0.25 s}}
swarm:
  - platform: lily
    count: {robots}
    prefix: lily
    controller: boids_blt
    start: {{box: {{centre: [0 m, 0 m, -1 m], size: [0.9 m, 0.9 m, 0.9 m]}}}}
lockstep: {{silent_controller: {silent}, patience: {patience} s}}
recording: {{topics: {topics}}}
"""


class Running:
    """One process, its output in a file; a wait that fails says for what."""

    def __init__(self, command: list[str], log: Path, environment: dict[str, str]) -> None:
        self.log = log
        with log.open("wb") as file:
            self.process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=file,
                stderr=subprocess.STDOUT,
                env={**os.environ, "COLUMNS": "400", **environment},
                start_new_session=True,
            )
        self.nodes: dict[str, int] = {}

    @property
    def output(self) -> str:
        """What it has printed so far."""
        return self.log.read_text(errors="replace")

    def say(self, *lines: str) -> None:
        """Lines to its standard input."""
        assert self.process.stdin is not None
        self.process.stdin.write("".join(f"{line}\n" for line in lines).encode())
        self.process.stdin.flush()

    def wait_for(self, pattern: str, times: int = 1) -> re.Match[str]:
        """The first match of `pattern` in its output, once there are so many; fails if it ends without them."""
        deadline = time.monotonic() + LIMIT
        while True:
            ended = self.process.poll() is not None
            found = list(re.finditer(pattern, self.output))
            if len(found) >= times:
                return found[0]
            assert not ended, f"ended without {pattern!r}:\n{self.output}"
            assert time.monotonic() < deadline, f"no {pattern!r} in:\n{self.output[-2000:]}"
            time.sleep(0.02)

    def find_nodes(self) -> dict[str, int]:
        """Process ids of the nodes of a run, by the names of their logs."""
        for child in children(self.process.pid):
            try:
                log = Path(os.readlink(f"/proc/{child}/fd/1"))
            except OSError:
                continue
            if log.parent.name == "log":
                self.nodes[log.stem] = child
        return self.nodes

    def interrupt(self) -> None:
        """What Ctrl-C on a terminal does: SIGINT to every process of the group."""
        for pid in [*children(self.process.pid), self.process.pid]:
            signal_if_there(pid, signal.SIGINT)

    def finish(self) -> int:
        """Its exit status."""
        return self.process.wait(LIMIT)

    def clean_up(self) -> None:
        """End it and its nodes, however they are; first in a way that leaves nothing in shared memory."""
        self.process.terminate()
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(PATIENCE)
        for pid in [*children(self.process.pid), *self.nodes.values()]:
            if self.process.poll() is None or pid in self.nodes.values():
                signal_if_there(pid, signal.SIGKILL)
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait(LIMIT)
        if self.process.stdin is not None:
            self.process.stdin.close()


def children(pid: int) -> list[int]:
    """The processes that a process has started."""
    try:
        return [int(word) for word in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def is_alive(pid: int) -> bool:
    """Whether a process is there and no zombie."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def signal_if_there(pid: int, number: int) -> None:
    """Send a signal to a process that may have ended."""
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Callable[..., Running]]:
    """Function of a command and its arguments: the running process; all end with the test."""
    running: list[Running] = []

    def begin(command: str | Path, *arguments: Any, env: dict[str, str] | None = None) -> Running:
        program = [sys.executable, str(command)] if str(command).endswith(".py") else [str(BIN / command)]
        log = tmp_path / f"output_{len(running)}.txt"
        running.append(Running([*program, *map(str, arguments)], log, env or {}))
        return running[-1]

    yield begin
    for process in reversed(running):
        process.clean_up()


@pytest.fixture
def scenario(tmp_path: Path) -> Callable[..., Path]:
    """Function of (robots, ticks) and lock-step settings: the file of a small scenario."""

    def write(robots: int = 2, ticks: int = 6, **settings: Any) -> Path:
        values = {"seed": 1, "silent": "thrusters_off", "patience": 60, "topics": "all", **settings}
        path = tmp_path / f"small_{robots}_{ticks}.yaml"
        path.write_text(SCENARIO.format(robots=robots, duration=0.5 * ticks, **values))
        return path

    return write


@pytest.fixture
def begin(
    start: Callable[..., Running], scenario: Callable[..., Path], tmp_path: Path
) -> Callable[..., tuple[Running, Path]]:
    """Function of robots, ticks, who of them is external, options, and settings of the scenario: a run and its bag."""

    def begin(robots: int, ticks: int, *external: str, options: tuple[Any, ...] = (), **settings: Any) -> Any:
        outside = [word for robot in external for word in ("--external", robot)]
        path = scenario(robots, ticks, **settings)
        run = start("cocorosim", "run", path, *outside, *options, "--out", tmp_path / "run")
        return run, tmp_path / "run" / "bag"

    return begin


@pytest.fixture
def paced(start: Callable[..., Running]) -> Callable[..., Running]:
    """Function of (run, robot): an external controller that answers when it is told to.

    Its environment is what the run has told its user to export; its transports are those of any rclpy process.
    """

    def begin(run: Running, robot: str, *arguments: Any) -> Running:
        exports = run.wait_for(r"export ROS_DOMAIN_ID=(\d+) ROS_AUTOMATIC_DISCOVERY_RANGE=(\w+)")
        env = {"ROS_DOMAIN_ID": exports[1], "ROS_AUTOMATIC_DISCOVERY_RANGE": exports[2]}
        return start(PACED, robot, *arguments, env=env)

    return begin


@pytest.fixture
def all_ended() -> Callable[[Running], None]:
    """Function of a run: fails if one of its nodes is still there after a while."""

    def check(run: Running) -> None:
        deadline = time.monotonic() + 30.0
        while alive := [name for name, pid in run.nodes.items() if is_alive(pid)]:
            assert time.monotonic() < deadline, f"left behind: {alive}"
            time.sleep(0.05)

    return check


@pytest.fixture
def counts() -> Callable[[Path], dict[str, int]]:
    """Function of a bag folder: messages per topic, as the independent package `rosbags` reads them."""
    from rosbags.rosbag2 import Reader

    def count(bag: Path) -> dict[str, int]:
        with Reader(bag) as reader:
            return {connection.topic: connection.msgcount for connection in reader.connections}

    return count


@pytest.fixture
def statuses() -> Callable[[Path], list[tuple[float, str, str]]]:
    """Function of a bag folder: stamp [s], name and message of everything on /diagnostics, read by `rosbags`."""
    from rosbags.highlevel import AnyReader

    def read(bag: Path) -> list[tuple[float, str, str]]:
        with AnyReader([bag]) as reader:
            chosen = [connection for connection in reader.connections if connection.topic == "/diagnostics"]
            arrays = [reader.deserialize(data, kind.msgtype) for kind, _, data in reader.messages(chosen)]
        return [
            (array.header.stamp.sec + array.header.stamp.nanosec / 1e9, status.name, status.message)
            for array in arrays
            for status in array.status
        ]

    return read


@pytest.fixture
def diagnostics(
    statuses: Callable[[Path], list[tuple[float, str, str]]],
) -> Callable[[Path], list[tuple[str, str]]]:
    """Function of a bag folder: name and message of everything on /diagnostics."""
    return lambda bag: [(name, message) for _, name, message in statuses(bag)]
