"""metrics_node: records every topic of a run into a bag and measures the shoal, live on /shoal_statistics.

With `scenario` it knows robots and topics from there; with `robots` it records real robots of `platform`.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rclpy.node import Node

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.json_file import json_text
from cocorosim_ros.graph.nodes.arrival_recorder import ArrivalRecorder
from cocorosim_ros.graph.nodes.complaints import tell_on_terminal
from cocorosim_ros.graph.nodes.ears import ears_of
from cocorosim_ros.graph.nodes.graph import OpenViewers
from cocorosim_ros.graph.nodes.node_shell import on_termination, ros_node, run_main
from cocorosim_ros.graph.nodes.parameters import NodeParameter, declare, usage_lines, warn_of_unknown
from cocorosim_ros.graph.nodes.physics_node import scenario_of
from cocorosim_ros.graph.nodes.recorder_link import RecorderMouth
from cocorosim_ros.graph.nodes.tick_recorder import TickRecorder
from cocorosim_ros.graph.nodes.wiring import Waiter
from cocorosim_ros.graph.runs.results import recording_metadata
from cocorosim_ros.graph.runs.run_record import RunRecord, Selection
from cocorosim_ros.graph.runs.scenery import Scenery
from cocorosim_ros.graph.runs.warm_up import compile_recorder
from cocorosim_ros.scenario.parts.controller_file import load_controller
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.scenario import RobotDescription, Scenario
from cocorosim_ros.wire.live.opening import foxglove_server
from cocorosim_ros.wire.topics.body import BodyDescription, describe_body

PARAMETERS = (
    NodeParameter("scenario", "", "scenario of the run; empty: `robots` and `platform` say what is there"),
    NodeParameter("seed", -1, "seed of the run; -1: the scenario's own", (-1, 2**63 - 1)),
    NodeParameter("external", "", "robots that somebody else controls, separated by spaces"),
    NodeParameter("duration", "", "length of the run such as '60 s'; empty: the scenario's own"),
    NodeParameter("robots", "", "names of the robots to record without a scenario, separated by spaces"),
    NodeParameter("platform", "lily", "platform of these robots"),
    NodeParameter("out", "bag", "folder of the recording; must not exist"),
    NodeParameter("force", False, "replace a recording that is there"),
    NodeParameter("summary", "", "file for the statistics of the run as JSON, replaced if it is there; empty: none"),
    NodeParameter("lock_step", True, "with a scenario in lock-step: write whole ticks, hold the physics node back"),
    NodeParameter("foxglove", -1, "port on which Foxglove finds all topics live, 0: any; -1: none", (-1, 65535)),
    NodeParameter("period", 0.5, "s between measurements of poses whose stamps do not coincide", (0.001, 3600.0)),
)
USAGE = f"""{__doc__}
Usage: metrics_node [--ros-args -p NAME:=VALUE ...]
Parameters:
{usage_lines(PARAMETERS)}"""
POLL = 0.02  # s; the recorder sleeps so long between draining its topics, or
POLL_OF_TOPIC = 2e-4  # s for each of them, so that to look at hundreds does not cost more than to take what is there
QUIET = 1.0  # s without any message after which a recorder that was told to stop closes
LAST_ARRIVALS = 3.0  # s after which it closes although real robots go on publishing
LAST_ANSWERS = 0.3  # s; the last commands of external controllers may come after the end of the run


@dataclass(frozen=True)
class Subject:
    """What is recorded."""

    bodies: tuple[BodyDescription, ...]
    origin: dict[str, str]  # what the bag says of where it comes from
    scenery: Scenery
    external: tuple[str, ...] = ()
    selection: Selection = "all"


def subject_of(values: dict[str, Any], scenario: Scenario | None) -> Subject:
    """What the parameters say is there; `scenario` if it was read already. Raises CocorosimError."""
    if values["scenario"]:
        scenario = scenario or scenario_of(values)
        bodies = tuple(describe_body(robot) for robot in scenario.robots)
        origin, scenery = recording_metadata(scenario), Scenery.of(scenario)
        return Subject(bodies, origin, scenery, scenario.external, scenario.recording.topics)
    names = values["robots"].split()
    if not names:
        raise CocorosimError("metrics_node: give 'scenario', or 'robots' with the names of the robots to record.")
    platform, idle = load_platform(values["platform"]), load_controller("idle")
    robots = [RobotDescription(name, platform, idle, external=True) for name in names]
    return Subject(tuple(describe_body(robot) for robot in robots), {"robots": " ".join(names)}, Scenery(robots))


class _Life:
    """Whether the node has been told to stop, and since when nothing has come in."""

    def __init__(self, *, supervised: bool) -> None:
        self.stop = False
        self._heard = self._told = time.monotonic()
        on_termination(self._end, supervised=supervised)

    def note(self, *, heard: bool) -> None:
        """Note that the topics were looked at, and whether something was there."""
        if heard:
            self._heard = time.monotonic()

    def quiet_for(self, seconds: float) -> bool:
        """Whether nothing has come in for so long."""
        return time.monotonic() - self._heard > seconds

    def stopped_for(self, seconds: float) -> bool:
        """Whether it was told to stop so long ago."""
        return self.stop and time.monotonic() - self._told > seconds

    def _end(self) -> None:
        self.stop = True
        self._told = time.monotonic()


def record_ticks(node: Node, record: RunRecord, life: _Life, external: Sequence[str]) -> None:
    """Record a lock-step run to its end, or until told to stop and quiet."""
    with ears_of(node, len(record.topics)) as nodes:
        _record_ticks(TickRecorder(nodes, record, external), nodes[0], life, external)


def _record_ticks(recorder: TickRecorder, node: Node, life: _Life, external: Sequence[str]) -> None:
    waiter = Waiter(node, 1)
    pause = max(POLL, POLL_OF_TOPIC * len(recorder.record.topics))
    while not recorder.is_complete and not (life.stop and life.quiet_for(QUIET)):
        ready = recorder.announce_when_connected()
        life.note(heard=recorder.drain())
        waiter.wait([recorder.clock], pause if ready else 0.005)
        time.sleep(pause if ready and recorder.announced is None else 0.0)
    while external and not life.quiet_for(LAST_ANSWERS):
        life.note(heard=recorder.drain())
        time.sleep(POLL)
    for robot, count in recorder.unheard_commands().items():
        tell_on_terminal(
            f"{robot}: {count} of the commands that it obeyed are not in the recording, because its controller joined "
            "after the start and the recorder found it later than the physics node; start it before the run"
        )
    recorder.write_rest()


def record_arrivals(node: Node, record: RunRecord, life: _Life, period: float) -> None:
    """Record whatever comes until the run has ended or until told to stop, and quiet."""
    recorder, mouth = ArrivalRecorder(node, record, period=period), RecorderMouth(node)
    ready = False
    while not life.stopped_for(LAST_ARRIVALS) and not (
        (life.stop or recorder.announced is not None) and life.quiet_for(QUIET)
    ):
        if not ready and mouth.is_heard and recorder.connected():
            mouth.say(0)
            ready = True
        life.note(heard=recorder.drain())
        time.sleep(POLL)
    recorder.finish()


def run_metrics(node: Node, scenario: Scenario | None = None, show: OpenViewers | None = None) -> None:
    """The node's life: the bag is closed and valid at its end, however it comes.

    `scenario`, read already, is given by a supervisor, and `show`, which opens viewers that are shown everything.
    """
    values = declare(node, PARAMETERS)
    warn_of_unknown(node)
    subject = subject_of(values, scenario)
    if scenario is None:
        compile_recorder(subject.bodies, node.get_logger().info)
    life = _Life(supervised=scenario is not None)
    folder = Path(values["out"])
    with ExitStack() as stack:
        record = RunRecord(
            folder,
            subject.bodies,
            subject.origin,
            selection=subject.selection,
            scenery=subject.scenery,
            force=values["force"],
        )
        if values["foxglove"] >= 0:
            viewers = stack.enter_context(foxglove_server(values["foxglove"], node.get_name()))
            record.show_to(viewers)
            node.get_logger().info(f"Foxglove and Lichtblick: {viewers.address}")
        if show is not None:
            record.show_to(stack.enter_context(show()))
        if scenario is None:
            node.get_logger().info(f"ready: records {len(record.topics)} topics into {folder}")
        if values["lock_step"] and values["scenario"]:
            record_ticks(node, record, life, subject.external)
        else:
            record_arrivals(node, record, life, values["period"])
        record.close()
    if values["summary"]:
        Path(values["summary"]).write_text(json_text(record.summary()), "utf-8")


def metrics(arguments: Sequence[str]) -> None:
    """Run the node until the run has ended or it is told to stop. Raises CocorosimError."""
    with ros_node("metrics_node", arguments, services="now") as node:
        run_metrics(node)


def main() -> None:
    """Entry point of `ros2 run cocorosim_ros metrics_node`."""
    sys.exit(run_main(metrics, USAGE))
