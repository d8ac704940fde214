"""Starts the processes of a node graph, watches them, ends them; whatever happens, none is left behind.

Processes are forked from one that has everything imported and compiled, so that thirteen of them start in about a
second. rclpy is initialised after the fork, in each of them.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from multiprocessing.connection import wait

from cocorosim_ros.graph.nodes.controller_node import run_controllers
from cocorosim_ros.graph.nodes.graph import GraphPlan, crew_name
from cocorosim_ros.graph.nodes.metrics_node import run_metrics
from cocorosim_ros.graph.nodes.node_process import NodeProcess
from cocorosim_ros.graph.nodes.node_shell import Services, ros_node, ros_nodes
from cocorosim_ros.graph.nodes.physics_node import Supervision, run_physics
from cocorosim_ros.graph.nodes.rclpy_internals import load_type_support
from cocorosim_ros.graph.nodes.shared_state import SharedState
from cocorosim_ros.graph.nodes.wiring import message_class
from cocorosim_ros.graph.runs.run_error import RunError
from cocorosim_ros.graph.runs.run_record import run_topics
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.topics import TOPICS

END_PATIENCE = 10.0  # s that processes get to end by themselves
CLOSE_PATIENCE = 120.0  # s that the recorder gets to write what it has heard
LOOK = 0.1  # s between looks at the processes


class Supervisor:
    """One running graph."""

    def __init__(self, plan: GraphPlan, warn: Callable[[str], None]) -> None:
        """Start nothing yet; `warn` is told what goes wrong while the run goes on."""
        self.plan = plan
        self.state = SharedState(len(plan.scenario.robots))
        self.interrupted = False
        self._warn = warn
        self._processes: list[NodeProcess] = []
        self._controllers: list[tuple[NodeProcess, Sequence[int]]] = []  # with the numbers of their robots
        self._told: set[NodeProcess] = set()
        self._failed_controller: NodeProcess | None = None  # one in plain Python that ends the run

    def interrupt(self) -> None:
        """Let the run end in order, at the next look."""
        self.interrupted = True

    def start(self) -> None:
        """Start all processes, unless interrupted."""
        _load_message_types(self.plan)
        sys.stdout.flush()
        sys.stderr.flush()
        self._metrics = self._begin("metrics_node", self._metrics_life)
        self._physics = self._begin("physics_node", self._physics_life)
        for numbers in self.plan.crews():
            if not self.interrupted:
                robots = [self.plan.scenario.robots[number] for number in numbers]
                process = self._begin(crew_name([robot.name for robot in robots]), self._controllers_life(robots))
                self._controllers.append((process, numbers))

    def watch(self, show: Callable[[SharedState], None]) -> None:
        """Return when the run has ended, or was interrupted, and its bag is closed.

        Raises RunError with the sentence of whichever process failed.
        """
        limit = float("inf")
        while not self._physics.ended and not self._metrics_failed and time.monotonic() < limit:
            wait([process.process.sentinel for process in (self._physics, self._metrics) if not process.ended], LOOK)
            self._look_around()
            show(self.state)
            if self.interrupted or self._failed_controller is not None:
                self._physics.ask_to_end()
            if (
                self.interrupted or self._failed_controller is not None or self._metrics.ended
            ):  # then the physics node has little left to do
                limit = min(limit, time.monotonic() + END_PATIENCE)
        if not self._physics.ended and not self._is_done:
            self._physics.end(0.0)
            self._fail_unless_interrupted(self._failed_controller or self._metrics)
        self._close_recording()
        self._look_around()
        if self._failed_controller is not None:
            self._fail_unless_interrupted(self._failed_controller)
        if self._physics.failed:
            self._fail_unless_interrupted(self._physics)

    def end(self) -> None:
        """End every process."""
        for process in self._processes:
            process.ask_to_end()
        deadline = time.monotonic() + END_PATIENCE
        for process in self._processes:
            process.end(deadline - time.monotonic())

    def _begin(self, name: str, life: Callable[[], None]) -> NodeProcess:
        logs = self.plan.out / "log"
        logs.mkdir(exist_ok=True)
        recorder = name == "metrics_node"
        self._processes.append(NodeProcess(name, life, logs / f"{name}.txt", closes_files=recorder))
        return self._processes[-1]

    def _fail_unless_interrupted(self, process: NodeProcess) -> None:
        if not self.interrupted:
            done = f"{self.state.ticks} of {self.plan.scenario.ticks} ticks were done"
            raise RunError(f"{process.last_words().rstrip('.')}; {done}.")

    def _look_around(self) -> None:
        """Pass on what the nodes warn of, and the deaths of controllers."""
        for words in (*self._physics.warnings(), *self._metrics.warnings()):
            self._warn(words)
        for process, numbers in self._controllers:
            if process.ends_run:
                self._failed_controller = self._failed_controller or process
            elif process.ended and process not in self._told and not self._physics.ended:
                self._told.add(process)
                for number in numbers:
                    self.state.mark_dead(number)
                self._warn(f"{process.last_words()}, tick {self.state.ticks}")

    @property
    def _is_done(self) -> bool:
        return self.state.closed and self.state.ticks == self.plan.scenario.ticks

    @property
    def _metrics_failed(self) -> bool:
        return self._metrics.failed and not self.state.closed

    def _close_recording(self) -> None:
        """Wait until the recorder has written everything; if the run ended out of order, tell it to close."""
        if self._physics.failed or self.interrupted or self._failed_controller is not None:
            self._metrics.ask_to_end()
        deadline = time.monotonic() + CLOSE_PATIENCE
        while not self.state.closed and not self._metrics.ended and time.monotonic() < deadline:
            wait([self._metrics.process.sentinel], LOOK)
        self._metrics.end(END_PATIENCE)
        if self._metrics_failed:
            self._fail_unless_interrupted(self._metrics)

    @property
    def _services(self) -> Services:
        """By the wall clock at once, so that making them delays no tick."""
        return "now" if self.plan.rate else "later"

    def _physics_life(self) -> None:
        with ros_node("physics_node", self.plan.physics_arguments(), services=self._services) as node:
            run_physics(node, Supervision(self.plan.scenario, self.state.report, self.state.dead))

    def _metrics_life(self) -> None:
        with ros_node("metrics_node", self.plan.metrics_arguments(), services=self._services) as node:
            run_metrics(node, self.plan.scenario, self.plan.show)
            self.state.mark_closed()

    def _controllers_life(self, robots: Sequence[RobotDescription]) -> Callable[[], None]:
        arguments = [self.plan.controller_arguments(robot.name) for robot in robots]

        def life() -> None:
            with ros_nodes("controller_node", arguments, services=self._services) as nodes:
                run_controllers(nodes, robots)

        return life


def _load_message_types(plan: GraphPlan) -> None:
    """Load what every process would otherwise load by itself after the fork."""
    topics = run_topics([describe_body(robot) for robot in plan.scenario.robots])
    for row in sorted(set(topics.values())):
        load_type_support(message_class(TOPICS[row].type_name))
