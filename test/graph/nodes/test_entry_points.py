"""The nodes as commands of their own, as `ros2 run` starts them: help, parameters, refusals, three shells together."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from urdf_parser_py.urdf import URDF

from cocorosim_ros.graph.nodes.node_shell import run_main
from cocorosim_ros.graph.nodes.path_choice import PATH_VARIABLE
from cocorosim_ros.wire.bags.bag_folder import make_room
from cocorosim_ros.wire.bags.bag_reader import read_bag

BIN = Path(sys.executable).parent
ONLOOKER = Path(__file__).with_name("onlooker.py")
NODES = ("physics_node", "controller_node", "metrics_node")
LIMIT = 200.0  # s; only a hang takes so long
STRING, BOOL, INTEGER, DOUBLE = 4, 1, 2, 3  # rcl_interfaces/msg/ParameterType
Starter = Callable[..., Any]


@pytest.fixture
def shell(free_domain: str) -> dict[str, str]:
    """The environment of all shells of one test: a domain that nobody uses, on this machine."""
    return {"ROS_DOMAIN_ID": free_domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


def ros_arguments(**values: object) -> list[str]:
    """Parameters as a user types them."""
    return ["--ros-args", *(word for name, value in values.items() for word in ("-p", f"{name}:={value}"))]


def run_node(shell: dict[str, str], *command: object) -> subprocess.CompletedProcess[str]:
    """The node's end, which comes by itself."""
    words = [str(BIN / str(command[0])), *map(str, command[1:])]
    return subprocess.run(
        words, env={**os.environ, **shell}, capture_output=True, text=True, timeout=LIMIT, check=False
    )


@pytest.mark.parametrize("node", NODES)
def test_help(node: str, shell: dict[str, str]) -> None:
    """It names the node and each of its parameters."""
    done = run_node(shell, node, "--help")
    assert done.returncode == 0
    assert done.stdout.startswith(f"{node}: ")
    assert "scenario (default " in done.stdout


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (("physics_node", *ros_arguments(rate="fast")), "parameter 'rate' has 'fast'; give a number"),
        (("physics_node", *ros_arguments(rate=-1.0)), "parameter 'rate' has -1.0, which is out of range; give 0 to"),
        (("physics_node", *ros_arguments(scenario="no_such")), "no_such"),
        (("physics_node", "eleven_lilys"), "physics_node does not know 'eleven_lilys'"),
        (("controller_node",), "controller_node has no namespace"),
        (("controller_node", "--ros-args", "-r", "__ns:=/lily_99", "-p", "scenario:=one_lily"), "no such robot"),
        (("metrics_node",), "give 'scenario', or 'robots'"),
        (("metrics_node", "--ros-args", "-p", "nonsense"), "nonsense"),
    ],
)
def test_refusals(command: tuple[str, ...], words: str, shell: dict[str, str]) -> None:
    """Unusable input: one sentence on standard error, status 2."""
    done = run_node(shell, *command)
    assert done.returncode == 2, done.stderr
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stderr.strip().count("\n") == 0, done.stderr


def test_a_launch_user_is_told_of_parameters(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """What a command calls --force is force:=true for a node and a launch file."""
    monkeypatch.setattr(sys, "argv", ["metrics_node"])
    assert run_main(lambda arguments: make_room(tmp_path, force=False), "") == 2
    assert capsys.readouterr().err == (
        f"{tmp_path} exists already; choose another folder, or replace it with force:=true.\n"
    )


def answers(onlooker: Any) -> list[Any]:
    """What was answered to each of its actions."""
    return [json.loads(line) for line in onlooker.output.splitlines() if line.startswith("[") and "INFO" not in line]


@pytest.mark.parametrize("ros_path", ["", "plain"])
def test_three_shells_give_the_bag_of_the_command(
    start: Starter, scenario: Callable[..., Path], tmp_path: Path, shell: dict[str, str], ros_path: str
) -> None:
    """Physics, controllers and recorder started by hand, in any order, work together and end together.

    The run is paused and stepped on the way, which leaves no trace in the recording.
    """
    shell = {**shell, PATH_VARIABLE: ros_path}
    path = scenario(2, 20)
    physics = start("physics_node", *ros_arguments(scenario=path, recorded="true"), env=shell)
    described = start(ONLOOKER, "describe", "/physics_node", env=shell)
    assert described.finish() == 0, described.output
    parameters = json.loads(described.output)
    assert parameters["scenario"]["value"] == str(path)
    assert parameters["recorded"]["type"] == BOOL
    assert parameters["rate"]["type"] == DOUBLE
    assert parameters["rate"]["range"] == [[0.0, 1e6]]
    assert parameters["seed"]["type"] == INTEGER
    assert parameters["seed"]["range"] == [[-1, 2**63 - 1]]
    own = {name: row for name, row in parameters.items() if name in ("scenario", "rate", "seed", "recorded", "wait")}
    assert len(own) == 5
    assert all(row["description"] and row["read_only"] == (name != "rate") for name, row in own.items())
    held = start(ONLOOKER, "do", "/physics_node/step", "/physics_node/pause=true", env=shell)
    assert held.finish() == 0, held.output
    assert answers(held) == [
        [False, "the run is not paused; call ~/pause with 'data: true' first"],
        [True, "paused at 0 s"],
    ]

    late = start(ONLOOKER, "description", "/lily_02/robot_description", env=shell)
    assert late.finish() == 0, late.output
    assert URDF.from_xml_string(late.output.strip().encode()).get_root() == "lily_02/base_link"

    controllers = [
        start("controller_node", "--ros-args", "-r", f"__ns:=/lily_0{number}", "-p", f"scenario:={path}", env=shell)
        for number in (1, 2)
    ]
    arguments = ros_arguments(scenario=path, out=tmp_path / "bag", summary=tmp_path / "summary.json")
    metrics = start("metrics_node", *arguments, env=shell)
    for node in (metrics, *controllers):
        node.wait_for("ready: ")
    stepped = start(ONLOOKER, "do", "/physics_node/step", "/physics_node/step", env=shell)
    assert stepped.finish() == 0, stepped.output
    assert [success for success, _ in answers(stepped)] == [True, True]
    physics.wait_for("a step is done: at 1 s now")
    freed = start(ONLOOKER, "do", "/physics_node/pause=true", "/physics_node/pause=false", env=shell)
    assert freed.finish() == 0, freed.output
    assert answers(freed) == [[True, "paused at 1 s"], [True, "going on at 1 s"]]
    assert metrics.finish() == 0, metrics.output
    for node, words in (
        (physics, "ready: 2 robots of 'small'"),
        (metrics, "ready: records "),
        (controllers[0], "ready: 'boids_blt'"),
    ):
        assert node.output.count(words) == 1
    assert physics.finish() == 0, physics.output
    for controller in controllers:
        controller.process.terminate()
        assert controller.finish() == 0, controller.output
    alone = start("cocorosim", "run", path, "--in-process", "--out", tmp_path / "alone")
    assert alone.finish() == 0, alone.output
    digests = [
        read_bag(bag).summary.metadata["cocorosim"]["digest"] for bag in (tmp_path / "bag", tmp_path / "alone/bag")
    ]
    assert digests[0] == digests[1]
    assert json.loads((tmp_path / "summary.json").read_text())["ticks"] == 20


def test_nodes_that_are_told_to_use_simulated_time_give_the_same_bag(
    start: Starter, scenario: Callable[..., Path], tmp_path: Path, shell: dict[str, str]
) -> None:
    """The parameter that every ROS node has: their ticks are simulated time anyway, and nothing waits for a clock."""
    path = scenario(2, 10)
    alone = start("cocorosim", "run", path, "--in-process", "--out", tmp_path / "alone")
    told = ros_arguments(use_sim_time="true", scenario=path)
    physics = start("physics_node", *told, "-p", "recorded:=true", env=shell)
    controllers = [start("controller_node", *told, "-r", f"__ns:=/lily_0{number}", env=shell) for number in (1, 2)]
    metrics = start("metrics_node", *told, "-p", f"out:={tmp_path / 'bag'}", env=shell)
    assert metrics.finish() == 0, metrics.output
    assert physics.finish() == 0, physics.output
    for controller in controllers:
        controller.process.terminate()
        assert controller.finish() == 0, controller.output
    assert alone.finish() == 0, alone.output
    digests = [
        read_bag(bag).summary.metadata["cocorosim"]["digest"] for bag in (tmp_path / "bag", tmp_path / "alone/bag")
    ]
    assert digests[0] == digests[1]


def test_metrics_node_records_real_robots(
    start: Starter, tmp_path: Path, shell: dict[str, str], counts: Callable[[Path], dict[str, int]]
) -> None:
    """Without a scenario: whatever the named robots publish, until it is told to stop; the bag is whole then."""
    toy = Path(__file__).parents[2] / "examples" / "toy_robot.py"
    robot = start(toy, "boat", env=shell)
    metrics = start("metrics_node", *ros_arguments(robots="boat", out=tmp_path / "bag"), env=shell)
    recording = tmp_path / "bag"
    deadline = time.monotonic() + LIMIT
    while not recording.exists():
        assert metrics.process.poll() is None, metrics.output
        assert time.monotonic() < deadline
        time.sleep(0.05)
    robot.wait_for(r"\n", times=robot.output.count("\n") + 5)
    metrics.process.terminate()
    robot.process.terminate()
    assert metrics.finish() == 0, metrics.output
    assert counts(recording)["/boat/compass"] > 0
    assert not read_bag(recording).summary.damage


@pytest.mark.parametrize("path", ["fast", "plain"])
def test_qualities_of_service_can_be_overridden(path: str, shell: dict[str, str], start: Starter) -> None:
    """A robot whose compass offers best effort is heard by who asks for no more; other topics are as ever."""
    name = "qos_overrides./lily_01/compass.subscription.reliability"
    arguments = [*ros_arguments(period=0.5), "-p", f"{name}:=best_effort", "-r", "__ns:=/lily_01"]
    start("controller_node", *arguments, env=shell if path == "fast" else {**shell, PATH_VARIABLE: path})
    seen = start(ONLOOKER, "qualities", "/lily_01/compass", "/lily_01/pressure", env=shell)
    assert seen.finish() == 0, seen.output
    assert json.loads(seen.output.splitlines()[-1]) == [
        {"controller_node": "BEST_EFFORT"},
        {"controller_node": "RELIABLE"},
    ]
