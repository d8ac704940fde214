"""Writes a made-up recording of poses and prints the most memory that commands take to read it.

    .venv/bin/python test/benchmark/long_recordings.py --hours 24

Robots swim on circles of their own, with 0.5 s between their poses. Memory is the most that the process had at once, of
its own and of files, as Linux tells it (VmHWM).
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build

POSE = "geometry_msgs/msg/PoseStamped"
FIELDS = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
TICK_NS = 500_000_000
# `resource` would also count the process from which this one was started.
CHILD = """
import re, sys
from pathlib import Path
from cocorosim_ros.commands.main import main
if sys.argv[1].isdigit():
    from cocorosim_ros.study.pictures import player
    player.MOST_POSES = int(sys.argv.pop(1))
try:
    main()
except SystemExit as ended:
    assert not ended.code, ended.code
print(re.search(r"VmHWM:\\s*(\\d+) kB", Path("/proc/self/status").read_text())[1])
"""


def write(folder: Path, robots: int, ticks: int) -> Path:
    """The recording."""
    packed = PackedMessage([build(POSE, {"header": {"frame_id": "world"}})] * robots, FIELDS)
    topics = [f"/lily_{robot:03d}/pose" for robot in range(robots)]
    phases, zero = np.arange(robots) * 0.5, np.zeros(robots)
    with BagWriter(folder, [Channel(topic, POSE) for topic in topics]) as bag:
        for tick in range(ticks):
            turn = phases + 0.01 * tick
            place = [np.cos(turn) + phases, np.sin(turn), zero - 1.0]
            values = np.column_stack([*place, zero, zero, np.sin(turn / 2), np.cos(turn / 2)])
            for topic, data in zip(topics, packed.encode(TICK_NS * tick, values), strict=True):
                bag.write(topic, TICK_NS * tick, TICK_NS * tick, data)
    return folder


def peak(command: Sequence[str], most_poses: int | None = None) -> float:
    """The most memory [MB] of `cocorosim` with these words; most_poses: on its page, in place of the usual number.

    Raises RuntimeError if the command fails.
    """
    page = [] if most_poses is None else [str(most_poses)]
    done = subprocess.run([sys.executable, "-c", CHILD, *page, *command], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr)
    return float(done.stdout.split()[-1]) / 1024


def main() -> None:
    """Write, read and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hours", type=float, default=24.0, help="length of the recording")
    parser.add_argument("--robots", type=int, default=11)
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        began = time.monotonic()
        bag = str(write(Path(folder) / "bag", chosen.robots, round(chosen.hours * 3600e9 / TICK_NS)))
        print(f"{chosen.robots} robots, {chosen.hours:g} h, written in {time.monotonic() - began:.0f} s")
        page, picture = str(Path(folder) / "page.html"), str(Path(folder) / "picture.png")
        commands = (["digest", bag], ["metrics", bag], ["metrics", bag, "--picture", picture])
        for command in (*commands, ["view", bag, "--no-open", "--out", page]):
            began = time.monotonic()
            print(f"{' '.join(command[:1] + command[2:3])}: {peak(command):.0f} MB, {time.monotonic() - began:.0f} s")


if __name__ == "__main__":
    main()
