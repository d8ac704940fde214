"""A recording that is four times as long takes hardly more memory."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build

POSE = "geometry_msgs/msg/PoseStamped"
FIELDS = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
ROBOTS, SHORT, LONG = 11, 6_000, 24_000
MOST = 18.0  # MB
# The most that a process has ever had in memory [kB]; `resource` also counts the process from which it was started.
CHILD = """
import re, sys
from pathlib import Path
from cocorosim_ros.commands.main import main
if sys.argv[1] == "view":
    from cocorosim_ros.study.pictures import player
    player.MOST_POSES = 20_000  # the page of the short recording is as long as that of the long one
try:
    main()
except SystemExit as ended:
    assert not ended.code, ended.code
print(re.search(r"VmHWM:\\s*(\\d+) kB", Path("/proc/self/status").read_text())[1])
"""


def write(folder: Path, ticks: int) -> Path:
    """Robots on circles of their own, 0.5 s a tick."""
    packed = PackedMessage([build(POSE, {"header": {"frame_id": "world"}})] * ROBOTS, FIELDS)
    topics = [f"/lily_{robot:02d}/pose" for robot in range(ROBOTS)]
    phases = np.arange(ROBOTS) * 0.5
    with BagWriter(folder, [Channel(topic, POSE) for topic in topics]) as bag:
        for tick in range(ticks):
            turn = phases + 0.01 * tick
            zero = np.zeros(ROBOTS)
            values = np.column_stack(
                [np.cos(turn) + phases, np.sin(turn), zero - 1.0, zero, zero, np.sin(turn / 2), np.cos(turn / 2)]
            )
            for topic, data in zip(topics, packed.encode(500_000_000 * tick, values), strict=True):
                bag.write(topic, 500_000_000 * tick, 500_000_000 * tick, data)
    return folder


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A short one and a long one."""
    folder = tmp_path_factory.mktemp("long")
    return write(folder / "short", SHORT), write(folder / "long", LONG)


@pytest.fixture
def peak(tmp_path: Path) -> Callable[[str, Path], float]:
    """A function from a command and a recording to the most memory [MB] that the command has had."""

    def measured(command: str, recording: Path) -> float:
        options = ["--no-open", "--out", str(tmp_path / "page.html"), "--force"] if command == "view" else []
        arguments = [sys.executable, "-c", CHILD, command, str(recording), *options]
        done = subprocess.run(arguments, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return float(done.stdout.split()[-1]) / 1024

    return measured


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the system does not tell a process its peak")
@pytest.mark.parametrize("command", ["metrics", "view"])
def test_memory_hardly_grows(recordings: tuple[Path, Path], peak: Callable[[str, Path], float], command: str) -> None:
    """18,000 ticks more of eleven robots: while all poses lay in memory, they took 30 MB more."""
    peak(command, recordings[0])  # compiles, which takes memory of its own
    short, long = (peak(command, recording) for recording in recordings)
    assert long - short < MOST
