"""The command in this process or in one of its own, and recordings to use it on."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.results import recording_metadata
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario

PROGRAM = "import sys; from cocorosim_ros.commands.main import main; sys.argv[0] = 'cocorosim'; main()"


@pytest.fixture(scope="session")
def run_of_20_seconds(tmp_path_factory: pytest.TempPathFactory) -> SimpleNamespace:
    """Five Lilys in lock-step for 40 ticks of 0.5 s: the folder of the bag, its digest, the statistics as measured
    live.
    """
    folder = tmp_path_factory.mktemp("run") / "bag"
    scenario = load_scenario("five_lilys", duration="20 s")
    bodies = [describe_body(robot) for robot in scenario.robots]
    record = RunRecord(folder, bodies, recording_metadata(scenario))
    run_in_process(scenario, record)
    digest = record.close()
    names = [body.name for body in bodies]
    return SimpleNamespace(bag=folder, digest=digest, live=record.summary(), robots=names, topics=list(record.topics))


@pytest.fixture
def domain(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """A ROS domain that nobody else uses, on this machine only, for this process and those that it starts."""
    from cocorosim_ros.graph.nodes.domain import OwnDomain, keep_on_this_machine

    for name in ("ROS_DOMAIN_ID", "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_LOCALHOST_ONLY", "ROS_STATIC_PEERS"):
        monkeypatch.delenv(name, raising=False)
    for name in ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"):
        monkeypatch.delenv(name, raising=False)
    own = OwnDomain()
    keep_on_this_machine(network=False)
    os.environ["ROS_DOMAIN_ID"] = str(own.number)
    yield own.number
    own.release()


@pytest.fixture
def start() -> Iterator[Callable[..., subprocess.Popen[str]]]:
    """A function of arguments that starts the command in a process of its own, which does not outlive the test."""
    started: list[subprocess.Popen[str]] = []

    def begin(*arguments: Any, program: str = PROGRAM) -> subprocess.Popen[str]:
        line = [sys.executable, "-c", program, *(str(argument) for argument in arguments)]
        process = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=Path.cwd())
        started.append(process)
        return process

    yield begin
    for process in started:
        process.terminate()  # in order, so that nothing is left in shared memory
        with suppress(subprocess.TimeoutExpired):
            process.wait(20.0)
        process.kill()
        process.communicate()
