"""controller_node: one robot's controller, in a simulation or on a real robot.

In a simulation it answers every complete set of readings. With `period` it works by the wall clock: every period
it takes the latest readings, drops what is older than `stale_after`, and commands. Its namespace is the robot's
name.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.nodes.controller_shell import ControllerShell
from cocorosim_ros.graph.nodes.node_shell import on_termination, ros_node, run_main
from cocorosim_ros.graph.nodes.parameters import NodeParameter, declare, usage_lines, warn_of_unknown
from cocorosim_ros.graph.nodes.rclpy_internals import given_parameters
from cocorosim_ros.graph.nodes.wiring import LONGEST_WAIT, Waiter
from cocorosim_ros.graph.runs.warm_up_controller import compile_controller
from cocorosim_ros.scenario.parts.controller_choice import AnyController, chosen_controller
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.controllers.plain.user_class import load_class

PARAMETERS = (
    NodeParameter("scenario", "", "scenario that has this robot; empty: `platform` and `controller` say what it is"),
    NodeParameter("platform", "lily", "platform of the robot: a name in config/platforms, or a file"),
    NodeParameter("controller", "boids_blt", "controller: a name in config/controllers, a file, or my_file.py:MyClass"),
    NodeParameter("seed", -1, "seed of its random numbers; -1: the scenario's own, 0 without one", (-1, 2**63 - 1)),
    NodeParameter("period", 0.0, "s of wall clock between commands; 0: answer every complete set", (0.0, 3600.0)),
    NodeParameter("stale_after", 2.0, "s after which a reading is no longer used (with period)", (0.0, 3600.0)),
    NodeParameter("listeners", 1, "subscriptions to wait for before the first command", (0, 1000)),
)
SETTING, FORMER_SETTING = "setting.", "controller."  # a parameter cannot lie beside others that its name begins
USAGE = f"""{__doc__}
Usage: controller_node --ros-args -r __ns:=/lily_01 [-p NAME:=VALUE ...]
Parameters (beside those of the controller, as setting.NAME, with the ranges of its file):
{usage_lines(PARAMETERS)}"""


def robot_of(node: Node, values: dict[str, Any]) -> tuple[RobotDescription, int]:
    """The robot that the node's namespace and parameters name, and its scenario's seed. Raises CocorosimError."""
    name = node.get_namespace().strip("/")
    if not name:
        raise CocorosimError(
            "controller_node has no namespace, which must be its robot's name; add '--ros-args -r __ns:=/lily_01'."
        )
    if not values["scenario"]:
        platform = load_platform(values["platform"])
        controller = chosen_controller(values["controller"], "parameter 'controller'")
        return RobotDescription(name, platform, adjusted(node, controller), external=False, acoustic=True), 0
    scenario = load_scenario(values["scenario"])
    robots = {robot.name: robot for robot in scenario.robots}
    if name not in robots:
        raise CocorosimError(
            f"controller_node in namespace /{name}: the scenario '{values['scenario']}' has no such robot; "
            f"its robots are {', '.join(robots)}."
        )
    robot = robots[name]
    return replace(robot, controller=adjusted(node, robot.controller), external=False), scenario.seed


def setting_parameters(controller: AnyController) -> tuple[NodeParameter, ...]:
    """The numbers of a controller as parameters; those of a user's class are arguments of its constructor."""
    if isinstance(controller, PythonController):
        arguments = load_class(controller).scalar_arguments()
        words = f"argument of {controller.name}"
        return tuple(NodeParameter(SETTING + name, value, words) for name, value in arguments.items())
    return tuple(
        NodeParameter(
            SETTING + name,
            parameter.value,
            f"{parameter.description} [{parameter.unit}]",
            None if isinstance(parameter.value, bool) else (parameter.minimum, parameter.maximum),
            changeable=True,
        )
        for name, parameter in controller.parameters.items()
    )


def adjusted(node: Node, controller: AnyController) -> AnyController:
    """The controller with the numbers that were given as ROS parameters setting.NAME. Raises CocorosimError."""
    for name in given_parameters(node):
        if name.startswith(FORMER_SETTING):
            new = SETTING + name.removeprefix(FORMER_SETTING)
            raise CocorosimError(f"{node.get_name()}: the parameter '{name}' is called '{new}'; give it by that name.")
    values = declare(node, setting_parameters(controller))
    return _with_settings(controller, {name.removeprefix(SETTING): value for name, value in values.items()})


def _with_settings(controller: AnyController, given: dict[str, Any]) -> AnyController:
    if isinstance(controller, PythonController):
        return replace(controller, parameters={**controller.parameters, **given})
    return controller.with_overrides(given)


def take_settings_while_running(node: Node, shell: ControllerShell, controller: AnyController) -> None:
    """Let parameters setting.NAME be changed; their ranges are checked by ROS, other rules here."""
    chosen = controller

    def on_parameters(parameters: list[Any]) -> SetParametersResult:
        nonlocal chosen
        given = {each.name.removeprefix(SETTING): each.value for each in parameters if each.name.startswith(SETTING)}
        try:
            wanted = _with_settings(chosen, given)
            shell.use(wanted)
        except CocorosimError as error:
            return SetParametersResult(successful=False, reason=str(error))
        chosen = wanted
        node.get_logger().info(", ".join(f"{name} is {value} from now on" for name, value in given.items()))
        return SetParametersResult(successful=True)

    node.add_on_set_parameters_callback(on_parameters)


def answer_sets(shells: Sequence[ControllerShell], waiter: Waiter) -> None:
    """Answer every complete set of readings of some robots until told to stop.

    Only where the topic that a robot waits for has come, its other topics are looked at.
    """
    stirred = shells
    while not any(shell.stop for shell in shells):
        for shell in stirred:
            while shell.answer_what_came():
                pass
        stirred = [shells[place] for place in waiter.wait([shell.awaited() for shell in shells], LONGEST_WAIT)]


def answer_periodically(shell: ControllerShell, node: Node, values: dict[str, Any]) -> None:
    """Answer every period of the wall clock until told to stop; says which readings are missing when that changes."""
    start, cycle, absent = time.monotonic(), 0, None
    while not shell.stop:
        cycle = max(cycle + 1, math.ceil((time.monotonic() - start) / values["period"]))  # what is missed is left out
        time.sleep(max(0.0, start + cycle * values["period"] - time.monotonic()))
        now = time.time_ns()
        shell.take()
        missing = shell.forget_stale(now - int(values["stale_after"] * 1e9))
        if missing != absent:
            absent = missing
            words = f"no recent {', '.join(missing)}" if missing else "all readings are there"
            node.get_logger().info(words)
        shell.answer(now, cycle * values["period"])


def run_controller(node: Node) -> None:
    """The life of a node that was started by itself, until it is told to stop."""
    values = declare(node, PARAMETERS)
    robot, seed = robot_of(node, values)
    warn_of_unknown(node)
    compile_controller(robot, node.get_logger().info)
    waiter = Waiter(node, 1)
    shell = ControllerShell(node, robot, seed if values["seed"] < 0 else values["seed"])
    take_settings_while_running(node, shell, robot.controller)
    on_termination(lambda: stop_all([shell]), supervised=False)
    node.get_logger().info(_ready(robot, values["period"]))
    if values["period"] > 0.0:
        answer_periodically(shell, node, values)
    else:
        shell.wait_until_heard(values["listeners"])
        answer_sets([shell], waiter)


def run_controllers(nodes: Sequence[Node], robots: Sequence[RobotDescription]) -> None:
    """The life of the nodes of robots that a supervisor has read and compiled, in one thread, until told to stop."""
    shells, listeners = [], []
    for node, robot in zip(nodes, robots, strict=True):
        values = declare(node, PARAMETERS)
        adjusted_robot = replace(robot, controller=adjusted(node, robot.controller))
        warn_of_unknown(node)
        shells.append(ControllerShell(node, adjusted_robot, values["seed"]))
        take_settings_while_running(node, shells[-1], adjusted_robot.controller)
        listeners.append(values["listeners"])
    waiter = Waiter(nodes[0], len(shells))
    on_termination(lambda: stop_all(shells), supervised=True)
    for shell, wanted in zip(shells, listeners, strict=True):
        shell.wait_until_heard(wanted)
    answer_sets(shells, waiter)


def stop_all(shells: Sequence[ControllerShell]) -> None:
    """Let controllers end after their present answer."""
    for shell in shells:
        shell.stop = True


def _ready(robot: RobotDescription, period: float) -> str:
    when = f"commands every {period:g} s" if period else "answers every complete set of readings"
    return f"ready: '{robot.controller.name}' {when} of {robot.name}"


def controller(arguments: Sequence[str]) -> None:
    """Run the node until it is told to stop. Raises CocorosimError."""
    with ros_node("controller_node", arguments, services="now") as node:
        run_controller(node)


def main() -> None:
    """Entry point of `ros2 run cocorosim_ros controller_node`."""
    sys.exit(run_main(controller, USAGE))
