"""The launch files, run against stand-ins of `launch` and `launch_ros`, which are not on PyPI."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from ruamel.yaml import YAML

from cocorosim_ros.graph.nodes import controller_node, metrics_node, physics_node
from cocorosim_ros.graph.nodes.graph import GraphPlan
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.world.checks.loading import load_scenario

ROOT = Path(__file__).parents[2]
LAUNCH = ROOT / "cocorosim_ros/graph/launch"
DECLARED = {
    "physics_node": {part.name: part for part in physics_node.PARAMETERS},
    "controller_node": {part.name: part for part in controller_node.PARAMETERS},
    "metrics_node": {part.name: part for part in metrics_node.PARAMETERS},
}


class Recorded:
    """An action or a substitution: what it was made with."""

    def __init__(self, *args: Any, **options: Any) -> None:
        self.args, self.options = args, options


class LaunchConfiguration(Recorded):
    """Looks a name up in the context, which is a dict here."""

    def perform(self, context: dict[str, str]) -> str:
        """Its value."""
        return context[self.args[0]]


CLASSES = {
    "launch": ("LaunchContext", "LaunchDescription"),
    "launch.actions": (
        "DeclareLaunchArgument",
        "ExecuteProcess",
        "OpaqueFunction",
        "SetEnvironmentVariable",
        "Shutdown",
    ),
    "launch.substitutions": ("EnvironmentVariable",),
    "launch_ros": (),
    "launch_ros.actions": ("Node",),
    "launch_ros.parameter_descriptions": ("ParameterValue",),
    "launch_ros.substitutions": ("ExecutableInPackage",),
}


@pytest.fixture(autouse=True)
def stand_ins(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Modules with the names that the documentation of Jazzy gives."""
    for module, names in CLASSES.items():
        stand_in = ModuleType(module)
        for name in names:
            setattr(stand_in, name, type(name, (Recorded,), {}))
        monkeypatch.setitem(sys.modules, module, stand_in)
    sys.modules["launch.substitutions"].LaunchConfiguration = LaunchConfiguration  # type: ignore[attr-defined]
    yield


def loaded(name: str) -> Any:
    """A launch file as a module."""
    spec = importlib.util.spec_from_file_location("launch_file", LAUNCH / name)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def launched(name: str, **given: str) -> list[SimpleNamespace]:
    """What a launch file starts: executable or command, namespace, plain parameters, other options."""
    actions = loaded(name).generate_launch_description().args[0]
    arguments = {a.args[0]: a for a in actions if type(a).__name__ == "DeclareLaunchArgument"}
    assert all(a.options["description"] for a in arguments.values())
    assert given.keys() <= arguments.keys()
    context = {key: action.options["default_value"] for key, action in arguments.items()} | given
    (function,) = [a.options["function"] for a in actions if type(a).__name__ == "OpaqueFunction"]
    return [started(action) for action in function(context)]


def started(action: Any) -> SimpleNamespace:
    """A Node or ExecuteProcess in plain words."""
    options = dict(action.options)
    parameters = {}
    for name, value in (options.pop("parameters", None) or [{}])[0].items():
        typed = type(value).__name__ == "ParameterValue"
        assert not typed or value.options == {"value_type": str}
        parameters[name] = value.args[0] if typed else value
    return SimpleNamespace(what=options.get("executable"), parameters=parameters, options=options)


@pytest.mark.parametrize("file", ["swarm.launch.py", "replay.launch.py"])
def test_arguments_are_parameters(file: str) -> None:
    """Every argument is called like the node's parameter that it becomes; a replay has its bag besides."""
    known = set().union(*DECLARED.values()) | ({"bag"} if file.startswith("replay") else set())
    assert loaded(file).ARGUMENTS.keys() <= known


@pytest.mark.parametrize("given", [{}, {"rate": "2.0", "external": "lily_03", "seed": "5", "duration": "60 s"}])
def test_the_swarm_gets_what_cocorosim_run_gives(given: dict[str, str]) -> None:
    """Same executables, namespaces and parameters as the supervised graph, each declared with that type."""
    rate = float(given.get("rate", "0.0"))
    external = given.get("external", "").split()
    nodes = launched("swarm.launch.py", **given)
    scenario = load_scenario("eleven_lilys", external=external or None)
    plan = GraphPlan(scenario, "eleven_lilys", Path("out"), rate)
    assert [n.what for n in nodes] == ["metrics_node", "physics_node"] + ["controller_node"] * len(plan.controlled_here)
    assert [n.options["namespace"] for n in nodes[2:]] == plan.controlled_here
    supervised = [plan.metrics_arguments(), plan.physics_arguments(), plan.controller_arguments("lily_01")]
    for node, arguments in zip(nodes[:3], supervised, strict=True):
        names = {word.split(":=")[0] for word in arguments if ":=" in word and not word.startswith("__")}
        # A launch file gives no summary and no time to wait, but may replace a recording.
        assert names - set(node.parameters) <= {"summary", "wait"}
        assert set(node.parameters) - names <= {"force"}
        for name, value in node.parameters.items():
            assert type(value) is type(DECLARED[node.what][name].default), name
    assert nodes[0].options["on_exit"]


def test_a_replay_plays_into_the_metrics_node(tmp_path: Path) -> None:
    """The metrics node knows the recording's robots; the player waits for all of its subscriptions."""
    from cocorosim_ros.graph.runs.run_record import RunRecord
    from cocorosim_ros.wire.topics.body import describe_body

    scenario = load_scenario("eleven_lilys", duration="1 s")
    bodies = [describe_body(robot) for robot in scenario.robots]
    record = RunRecord(tmp_path / "bag", bodies, {})
    run_in_process(scenario, record)
    record.close()
    metrics, player = launched("replay.launch.py", bag=str(tmp_path / "bag"), rate="3.0")
    assert metrics.parameters["robots"].split() == [robot.name for robot in scenario.robots]
    assert set(metrics.parameters) <= set(DECLARED["metrics_node"])
    executable, *words = player.options["cmd"]
    assert executable.args == ("cocorosim", "cocorosim_ros")
    # 9 topics of each robot, /clock, /tf and /diagnostics
    assert words == ["replay", str(tmp_path / "bag"), "--rate", "3.0", "--wait", str(9 * 11 + 3)]


def test_rviz_shows_the_frames_of_the_swarm() -> None:
    """The RViz configuration is YAML, looks from `world`, and shows tf."""
    content = YAML(typ="safe").load((ROOT / "config/rviz/swarm.rviz").read_text("utf-8"))["Visualization Manager"]
    assert content["Global Options"]["Fixed Frame"] == "world"
    assert "rviz_default_plugins/TF" in {display["Class"] for display in content["Displays"]}
