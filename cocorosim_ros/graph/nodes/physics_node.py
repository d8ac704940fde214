"""physics_node: the bodies and the water of one scenario, in lock-step with its controllers or by the wall clock."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from rclpy.node import Node

from cocorosim_ros.graph.nodes.background import run_callbacks
from cocorosim_ros.graph.nodes.node_shell import on_termination, ros_node, run_main
from cocorosim_ros.graph.nodes.parameters import NodeParameter, declare, usage_lines, warn_of_unknown
from cocorosim_ros.graph.nodes.physics_shell import PhysicsShell
from cocorosim_ros.graph.nodes.run_control import RunControl
from cocorosim_ros.graph.nodes.terms import Terms
from cocorosim_ros.graph.nodes.wiring import Waiter
from cocorosim_ros.graph.runs.between_ticks import steps_of_scenario
from cocorosim_ros.graph.runs.latency import check_latency
from cocorosim_ros.graph.runs.warm_up import compile_physics
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario

SMOOTH = "with a rate: Hz of simulated time of /clock and /tf, interpolated between ticks; 0: ticks alone"
PARAMETERS = (
    NodeParameter("scenario", "eleven_lilys", "name of a scenario in config/scenarios, or path of a file"),
    NodeParameter("seed", -1, "seed of the run; -1: the scenario's own", (-1, 2**63 - 1)),
    NodeParameter("external", "", "robots that somebody else controls, separated by spaces"),
    NodeParameter("duration", "", "length of the run such as '60 s'; empty: the scenario's own"),
    NodeParameter("rate", 0.0, "seconds of simulation per second of wall clock; 0: lock-step", (0.0, 1e6), True),
    NodeParameter("smooth", 0.0, SMOOTH, (0.0, 1000.0)),
    NodeParameter("recorded", False, "a metrics_node belongs to the run: wait for it, do not outrun it in lock-step"),
    NodeParameter("wait", 60.0, "s of wall clock that controllers and recorder get to appear", (0.0, 86400.0)),
)
USAGE = f"""{__doc__}

Usage: physics_node [--ros-args -p NAME:=VALUE ...]
Parameters:
{usage_lines(PARAMETERS)}"""

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Supervision:
    """What a supervised node has from its supervisor beside its parameters."""

    scenario: Scenario  # the same as the parameters name, read already
    report: Progress
    dead: Callable[[], list[int]]


def scenario_of(values: dict[str, Any]) -> Scenario:
    """The scenario that the parameters name. Raises CocorosimError."""
    return load_scenario(
        values["scenario"],
        seed=None if values["seed"] < 0 else values["seed"],
        duration=values["duration"] or None,
        external=values["external"].split() or None,
    )


def run_lock_step(shell: PhysicsShell, progress: Progress, control: RunControl | None = None) -> None:
    """All ticks, each as soon as every answer to the one before is there."""
    while _may_go_on(shell, control)[0]:
        shell.publish_tick()
        shell.gather()
        shell.advance()
        progress(shell.simulation.tick, shell.missing_answers)


def run_by_the_clock(shell: PhysicsShell, progress: Progress, control: RunControl) -> None:
    """All ticks at the rate that `control` has; a controller that has not answered by the next tick is late."""
    due = time.monotonic()
    while True:
        going, held = _may_go_on(shell, control)
        if not going:
            return
        due += held + shell.scenario.tick_ns * 1e-9 / control.rate
        shell.publish_tick()
        shell.gather_until(due, held)
        shell.advance_until_due()
        progress(shell.simulation.tick, shell.missing_answers)


def _may_go_on(shell: PhysicsShell, control: RunControl | None) -> tuple[bool, float]:
    """Whether another tick is to be done, and how long that was held up from outside [s, wall clock]."""
    held = 0.0
    if control is not None and shell.simulation.tick < shell.scenario.ticks:
        held = control.hold(shell.simulation.time_ns * 1e-9, lambda: shell.stop, shell.begin_anew)
    return not shell.stop and shell.simulation.tick < shell.scenario.ticks, held


def run_physics(node: Node, supervision: Supervision | None = None) -> None:
    """The node's life, from its parameters to the end of the run."""
    values = declare(node, PARAMETERS)
    warn_of_unknown(node)
    run_callbacks(node)
    control = RunControl(node, values["rate"], recorded=values["recorded"])
    scenario = scenario_of(values) if supervision is None else supervision.scenario
    steps = steps_of_scenario(scenario, values["smooth"], values["rate"])
    if supervision is None:
        check_latency(scenario)
        compile_physics(scenario, node.get_logger().info)
    waiter = Waiter(node, 2 * len(scenario.robots) + 1)

    def idle(listeners: Sequence[Any], seconds: float) -> None:
        if listeners:
            waiter.wait(listeners, seconds)
        else:
            time.sleep(seconds)

    dead = list if supervision is None else supervision.dead
    terms = Terms(values["recorded"], values["wait"], dead=dead, steps=steps)
    shell = PhysicsShell(node, scenario, idle, terms)
    progress: Progress = (lambda ticks, missing: None) if supervision is None else supervision.report
    on_termination(shell.request_stop, supervised=supervision is not None)
    if supervision is None:
        node.get_logger().info(_ready(scenario, values["rate"]))
    try:
        shell.wait_until_connected()
        if values["rate"] > 0.0:
            run_by_the_clock(shell, progress, control)
        else:
            run_lock_step(shell, progress, control)
    finally:
        shell.end()
        shell.linger()
        control.let_answers_arrive()


def _ready(scenario: Scenario, rate: float) -> str:
    pace = f"at {rate:g} x real time" if rate else "in lock-step"
    return f"ready: {len(scenario.robots)} robots of '{scenario.name}' {pace}, which begins when all are there"


def physics(arguments: Sequence[str]) -> None:
    """Run the node until the scenario has ended. Raises CocorosimError."""
    with ros_node("physics_node", arguments, services="now") as node:
        run_physics(node)


def main() -> None:
    """Entry point of `ros2 run cocorosim_ros physics_node`."""
    sys.exit(run_main(physics, USAGE))
