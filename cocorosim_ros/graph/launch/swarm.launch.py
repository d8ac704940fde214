"""A swarm on a full ROS installation: one physics node, a controller per robot, the metrics node.

ros2 launch cocorosim_ros swarm.launch.py scenario:=eleven_lilys out:=bag rate:=1.0
"""

from __future__ import annotations

from typing import Any

from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, Shutdown
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

from cocorosim_ros.world.checks.loading import load_scenario

PACKAGE = "cocorosim_ros"
ARGUMENTS = {
    "scenario": ("eleven_lilys", "name of a scenario in config/scenarios, or path of a file"),
    "seed": ("-1", "seed of the run; -1: the scenario's own"),
    "external": ("", "robots that somebody else controls, separated by spaces"),
    "duration": ("", "length of the run such as '60 s'; empty: the scenario's own"),
    "rate": ("0.0", "seconds of simulation per second of wall clock; 0: lock-step"),
    "smooth": (
        "0.0",
        "with a rate: Hz of simulated time of /clock and /tf, interpolated between ticks; 0: ticks alone",
    ),
    "out": ("bag", "folder of the recording; must not exist"),
    "force": ("false", "replace a recording that is there"),
    "foxglove": ("-1", "port on which Foxglove finds all topics live, 0: any; -1: none"),
}


def text(value: str) -> ParameterValue:
    """The value as a string, whatever YAML would make of it."""
    return ParameterValue(value, value_type=str)


def nodes(context: LaunchContext) -> list[Node]:
    """All nodes of the scenario that the arguments name."""
    given = {name: LaunchConfiguration(name).perform(context) for name in ARGUMENTS}
    scenario = load_scenario(given["scenario"], external=given["external"].split() or None)
    rate = float(given["rate"])
    run: dict[str, Any] = {name: text(given[name]) for name in ("scenario", "external", "duration")}
    run["seed"] = int(given["seed"])
    physics = {**run, "rate": rate, "smooth": float(given["smooth"]), "recorded": True}
    force = given["force"].lower() == "true"
    recorder = {"out": text(given["out"]), "force": force, "foxglove": int(given["foxglove"])}
    metrics = {**run, **recorder, "lock_step": rate == 0.0}
    controller = {"scenario": text(given["scenario"]), "seed": int(given["seed"]), "listeners": 2}
    return [
        # The recorder ends when the run has ended and everything is written.
        node("metrics_node", metrics, on_exit=Shutdown(reason="the run has ended")),
        node("physics_node", physics),
        *(node("controller_node", controller, namespace=r.name) for r in scenario.robots if not r.external),
    ]


def node(executable: str, parameters: dict[str, Any], **options: Any) -> Node:
    """One node of this package, with its words on the screen."""
    return Node(package=PACKAGE, executable=executable, parameters=[parameters], output="screen", **options)


def generate_launch_description() -> LaunchDescription:
    """What `ros2 launch` asks for."""
    arguments = [
        DeclareLaunchArgument(name, default_value=default, description=words)
        for name, (default, words) in ARGUMENTS.items()
    ]
    return LaunchDescription([*arguments, OpaqueFunction(function=nodes)])
