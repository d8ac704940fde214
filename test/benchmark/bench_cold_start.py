"""`python test/benchmark/bench_cold_start.py`: nodes started one by one, as `ros2 launch` does, with an empty cache.

Says how long each node took until it was ready, which of them compiled and which waited, how many answers were missed,
and the same once more with the cache that they have filled. Takes some minutes, so that no test does it.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from cocorosim_ros.graph.nodes.domain import OwnDomain
from cocorosim_ros.graph.nodes.graph import ros_arguments
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.cdr.status import RUN, read_status
from cocorosim_ros.world.checks.loading import load_scenario

BIN = Path(sys.executable).parent
LIMIT = 900.0  # s
INFO = re.compile(r"\[INFO\] \[(\d+\.\d+)\] \[[\w.]+\]: (.*)")


def start_nodes(scenario: str, duration: str, folder: Path, environment: dict[str, str]) -> dict[str, int]:
    """Start every node of a scenario at once, wait for their end; exit status of each, their words in files."""
    run = {"scenario": scenario, "duration": duration}
    commands = {
        "metrics_node": ros_arguments({**run, "out": str(folder / "bag")}),
        "physics_node": ros_arguments({**run, "recorded": True}),
    }
    for robot in load_scenario(scenario).robots:
        arguments = ros_arguments({"scenario": scenario, "listeners": 2})
        commands[f"controller_node {robot.name}"] = [*arguments, "-r", f"__ns:=/{robot.name}"]
    nodes = {}
    for name, arguments in commands.items():
        with (folder / f"{name}.txt").open("wb") as file:
            program = [str(BIN / name.split()[0]), *arguments]
            nodes[name] = subprocess.Popen(program, stdout=file, stderr=file, env=environment)
    try:
        nodes["metrics_node"].wait(LIMIT)
        nodes["physics_node"].wait(LIMIT)
    finally:
        for node in nodes.values():
            node.terminate()
    return {name: node.wait(30.0) for name, node in nodes.items()}


def tell(folder: Path, began: float, statuses: dict[str, int]) -> None:
    """Print what the nodes said of compiling and of being ready, and how the run ended."""
    for name, status in statuses.items():
        said = INFO.findall((folder / f"{name}.txt").read_text("utf-8"))
        words = "; ".join(f"{float(moment) - began:.0f} s: {sentence}" for moment, sentence in said)
        print(f"{name} ({status}): {words}")
    bag = read_bag(folder / "bag")
    for message in bag.messages(["/diagnostics"]):
        subject, sentence, values = read_status(message.data)
        print(f"{subject}: {sentence}" + (f", {values}" if subject == RUN else ""))


def main() -> None:
    """An empty cache, then a full one."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--scenario", default="eleven_lilys")
    parser.add_argument("--duration", default="30 s", help="of simulated time")
    options = parser.parse_args()
    domain = OwnDomain()
    with tempfile.TemporaryDirectory(prefix="cold_start_") as scratch:
        environment = {**os.environ, "NUMBA_CACHE_DIR": f"{scratch}/cache", "ROS_DOMAIN_ID": str(domain.number)}
        environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
        for cache in ("empty", "full"):
            folder = Path(scratch, cache)
            folder.mkdir()
            began = time.time()
            statuses = start_nodes(options.scenario, options.duration, folder, environment)
            print(f"cache {cache}: {time.time() - began:.0f} s from start to end")
            tell(folder, began, statuses)
    domain.release()


if __name__ == "__main__":
    main()
