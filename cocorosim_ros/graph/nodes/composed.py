"""All nodes of a graph in one process and one thread: the same topics, the same bag, no process switches."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack

import rclpy
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions

from cocorosim_ros.graph.nodes.background import wait_for_callbacks_to_end
from cocorosim_ros.graph.nodes.controller_shell import ControllerShell
from cocorosim_ros.graph.nodes.graph import GraphPlan
from cocorosim_ros.graph.nodes.physics_node import run_lock_step
from cocorosim_ros.graph.nodes.physics_shell import PhysicsShell
from cocorosim_ros.graph.nodes.terms import Terms
from cocorosim_ros.graph.nodes.tick_recorder import TickRecorder
from cocorosim_ros.graph.nodes.wiring import Listener, Waiter
from cocorosim_ros.graph.runs.results import recording_metadata
from cocorosim_ros.graph.runs.run_error import RunError
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.graph.runs.scenery import Scenery
from cocorosim_ros.wire.live.opening import foxglove_server
from cocorosim_ros.wire.topics.body import describe_body

CLOSE_PATIENCE = 10.0  # s of wall clock that the last messages get to arrive


class ComposedGraph:
    """Physics, controllers and recorder side by side; whoever has something to do does it when physics waits."""

    def __init__(self, plan: GraphPlan, record: RunRecord, tell: Callable[[str], None]) -> None:
        self.recorder = TickRecorder([_node("metrics_node")], record)
        self._controllers = [
            ControllerShell(_node("controller_node", robot.name), robot, plan.scenario.seed)
            for robot in plan.scenario.robots
        ]
        physics_node = _node("physics_node")
        terms = Terms(recorded=True, wait=plan.wait, tell=tell)
        self.physics = PhysicsShell(physics_node, plan.scenario, self._idle, terms)
        self._waiter = Waiter(physics_node, 1)

    def run(self, progress: Callable[[int, int], None]) -> None:
        """Run the scenario to its end, or until told to stop; everything is recorded then."""
        self.physics.wait_until_connected()
        run_lock_step(self.physics, progress)
        self.finish()

    def finish(self) -> None:
        """Record what is still on its way."""
        self.physics.end()
        deadline = time.monotonic() + CLOSE_PATIENCE
        while not self.recorder.is_complete and time.monotonic() < deadline:
            if not self.recorder.drain():
                self._waiter.wait([self.recorder.clock], 0.01)
        self.recorder.write_rest()

    def _idle(self, listeners: Sequence[Listener], seconds: float) -> None:
        self.recorder.announce_when_connected()
        worked = False
        for controller in self._controllers:
            worked = controller.answer_what_came() or worked
        if not worked and not self.recorder.drain() and listeners:
            self._waiter.wait(listeners[:1], min(seconds, 0.002))


def run_composed(
    plan: GraphPlan,
    on_start: Callable[[ComposedGraph], None],
    progress: Callable[[int, int], None],
    tell: Callable[[str], None],
) -> None:
    """Run a plan in this process; `tell` is told what goes wrong on the way.

    Raises CocorosimError; the bag is closed and valid however it ends, unless the disk takes no more.
    """
    with ExitStack() as stack:
        rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
        stack.callback(wait_for_callbacks_to_end, 1.0)
        stack.callback(rclpy.shutdown)
        scenario = plan.scenario
        bodies = [describe_body(robot) for robot in scenario.robots]
        selection = scenario.recording.topics
        metadata, scenery = recording_metadata(scenario), Scenery.of(scenario)
        record = RunRecord(plan.out / "bag", bodies, metadata, selection=selection, scenery=scenery)
        if plan.foxglove is not None:
            record.show_to(stack.enter_context(foxglove_server(plan.foxglove, scenario.name)))
        if plan.show is not None:
            record.show_to(stack.enter_context(plan.show()))
        stack.callback(record.close)
        graph = ComposedGraph(plan, record, tell)
        on_start(graph)
        try:
            graph.run(progress)
        except RunError:
            graph.finish()
            raise


def _node(name: str, namespace: str = "") -> Node:
    return Node(name, namespace=namespace, start_parameter_services=False, enable_rosout=False)
