"""Single runs for the benchmark, each called in a fresh process: the graph, its parts, composed, without ROS."""

from __future__ import annotations

import multiprocessing
import os
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from rich.console import Console
from stopwatch import Stopwatch

from cocorosim_ros.commands.run_modes import RunChoices, run_in_one_process, run_without_ros
from cocorosim_ros.graph.nodes import (
    controller_node,
    controller_shell,
    metrics_node,
    physics_node,
    physics_shell,
    wiring,
)
from cocorosim_ros.graph.nodes.domain import OwnDomain, keep_on_this_machine
from cocorosim_ros.graph.nodes.graph import GraphPlan
from cocorosim_ros.graph.nodes.shared_state import SharedState
from cocorosim_ros.graph.nodes.supervisor import Supervisor
from cocorosim_ros.graph.nodes.tick_recorder import TickRecorder
from cocorosim_ros.graph.runs.body_side import BodySide, SwarmMessages
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.graph.runs.warm_up import compile_everything
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.tick.simulation import Simulation

JIFFY = 1.0 / os.sysconf("SC_CLK_TCK")
PHYSICS, CONTROLLERS, RECORDER = "physics", "controllers", "recorder"
SENSE, ENCODE, PUBLISH, TAKE, WAIT = "sense and move", "encode", "publish", "take", "wait"
DECODE, DECIDE, MEASURE, WRITE, BETWEEN = "decode", "decide", "measure the shoal", "write the bag", "Python in between"
LABELS = (SENSE, ENCODE, PUBLISH, TAKE, DECODE, DECIDE, MEASURE, WRITE, WAIT, BETWEEN)


class NotCleanError(RuntimeError):
    """A run that tells nothing of speed."""


@dataclass(frozen=True)
class Case:
    """What is run: a scenario, and for how long."""

    source: str
    duration: str


@dataclass(frozen=True)
class Result:
    """How fast one run was and what it cost."""

    ticks: int
    tick: float  # s of simulation
    seconds: float  # of wall clock between the first tick and the last
    messages: int  # recorded
    processes: int
    cpu: dict[str, float] = field(default_factory=dict)  # role -> s of CPU per tick
    cores_busy: tuple[float, float] = (0.0, 0.0)  # by the graph, by everybody else
    parts: dict[str, dict[str, float]] = field(default_factory=dict)  # role -> label -> s of CPU per tick

    @property
    def per_tick(self) -> float:
        """Wall-clock seconds per tick."""
        return self.seconds / (self.ticks - 1)

    @property
    def factor(self) -> float:
        """Seconds of simulation per second of wall clock."""
        return self.tick / self.per_tick


@dataclass(frozen=True)
class Sample:
    """How far a graph is at one moment, and what its processes have used until then."""

    moment: float  # s, monotonic clock
    ticks: int
    cpu: dict[str, float]  # process -> s
    machine: float  # s of CPU of all processes of the machine


class CpuSamples:
    """CPU time of the processes of a graph, looked up while it runs."""

    def __init__(self) -> None:
        self._samples: list[Sample] = []

    def look(self, state: SharedState) -> None:
        """Look, if the run is under way and has moved on."""
        if state.ticks == (self._samples[-1].ticks if self._samples else 0):
            return
        used = {child.name: _cpu_seconds(child.pid) for child in multiprocessing.active_children()}
        if used.get("physics_node", 0.0) > 0.0:
            self._samples.append(Sample(time.monotonic(), state.ticks, used, _machine_seconds()))

    def per_tick(self) -> dict[str, float]:
        """Role -> seconds of CPU per tick, between the first look and the last."""
        total = dict.fromkeys((PHYSICS, CONTROLLERS, RECORDER), 0.0)
        if self._ticks() > 0:
            first, last = self._samples[0], self._samples[-1]
            for name, seconds in last.cpu.items():
                total[role(name)] += (seconds - first.cpu.get(name, 0.0)) / self._ticks()
        return total

    def cores_busy(self) -> tuple[float, float]:
        """How many cores the graph kept busy in that time, and how many everybody else on the machine."""
        if self._ticks() == 0:
            return 0.0, 0.0
        first, last = self._samples[0], self._samples[-1]
        seconds = last.moment - first.moment
        own = sum(self.per_tick().values()) * self._ticks() / seconds
        return own, max(0.0, (last.machine - first.machine) / seconds - own)

    def _ticks(self) -> int:
        return self._samples[-1].ticks - self._samples[0].ticks if self._samples else 0


def role(process: str) -> str:
    """What a process of the graph does."""
    return {"physics_node": PHYSICS, "metrics_node": RECORDER}.get(process, CONTROLLERS)


def _cpu_seconds(pid: int | None) -> float:
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) * JIFFY


def _machine_seconds() -> float:
    """CPU time of the whole machine since it started, less what it was idle."""
    numbers = [int(word) for word in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:]]
    return (sum(numbers[:8]) - numbers[3] - numbers[4]) * JIFFY


def graph(case: Case) -> Result:
    """Physics, recorder and controllers as processes."""
    return _graph(case, None)


def graph_in_parts(case: Case) -> Result:
    """The same with the nodes' functions timed, which makes it a little slower."""
    scenario = load_scenario(case.source, duration=case.duration)
    names = ["physics_node", "metrics_node", *(f"controller_{robot.name}" for robot in scenario.robots)]
    watch = Stopwatch(names, LABELS)
    _time_the_nodes(watch)
    result = _graph(case, watch)
    parts: dict[str, dict[str, float]] = {}
    for name in names:
        row = parts.setdefault(role(name), dict.fromkeys(LABELS, 0.0))
        for label in LABELS:
            row[label] += watch.seconds(name, label) / result.ticks
    return Result(**{**vars(result), "parts": parts})


def composed(case: Case) -> Result:
    """All nodes in this process."""
    return _by_command(case, run_in_one_process, composed=True)


def without_ros(case: Case) -> Result:
    """No nodes: the core, its recording and its statistics."""
    return _by_command(case, run_without_ros, in_process=True)


def _graph(case: Case, watch: Stopwatch | None) -> Result:
    scenario = load_scenario(case.source, duration=case.duration)
    domain, samples = OwnDomain(), CpuSamples()
    os.environ["ROS_DOMAIN_ID"] = str(domain.number)
    keep_on_this_machine(network=False)
    compile_everything(scenario)
    complaints: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        supervisor = Supervisor(GraphPlan(scenario, case.source, Path(folder)), complaints.append)
        try:
            supervisor.start()
            supervisor.watch(samples.look)
        finally:
            supervisor.end()
            domain.release()
        state, messages = supervisor.state, _messages_in(Path(folder))
    if complaints or state.missing_answers:
        raise NotCleanError(f"not a clean run: {complaints}, {state.missing_answers} answers missing")
    processes = 2 + len(supervisor.plan.crews())
    return Result(
        state.ticks, scenario.tick, state.seconds, messages, processes, samples.per_tick(), samples.cores_busy()
    )


def _by_command(case: Case, mode: Callable[..., object], **modes: bool) -> Result:
    scenario = load_scenario(case.source, duration=case.duration)
    compile_everything(scenario)
    with tempfile.TemporaryDirectory() as folder:
        given = {"scenario": case.source, "out": Path(folder), "duration": case.duration, "external": ()}
        given |= {"rate": 0.0, "smooth": 0.0}
        choices = RunChoices(**{**dict.fromkeys(RunChoices.__dataclass_fields__), "wait": 60.0, **given, **modes})
        outcome = mode(scenario, choices, Path(folder), Console(quiet=True))
        messages = _messages_in(Path(folder))
    return Result(outcome.ticks, scenario.tick, outcome.seconds, messages, 1)  # type: ignore[attr-defined]


def _messages_in(folder: Path) -> int:
    return sum(topic.count for topic in read_bag(folder / "bag").summary.topics)


def _time_the_nodes(watch: Stopwatch) -> None:
    """Let the stopwatch into the nodes; the processes are forked afterwards."""
    for owner, attribute, label in (
        (Simulation, "sense", SENSE),
        (Simulation, "advance", SENSE),
        (SwarmMessages, "poses", ENCODE),
        (SwarmMessages, "readings", ENCODE),
        (SwarmMessages, "clock", ENCODE),
        (BodySide, "_inboxes", ENCODE),
        (physics_shell.PhysicsShell, "take_answers", TAKE),
        (controller_shell.ControllerShell, "take", TAKE),
        (controller_shell.ObservationDecoder, "observation", DECODE),
        (controller_shell, "conduct_one", DECIDE),
        (controller_shell.AnswerEncoder, "command", ENCODE),
        (controller_shell.AnswerEncoder, "said", ENCODE),
        (RunRecord, "measure", MEASURE),
        (RunRecord, "write_tick", WRITE),
        (TickRecorder, "drain", TAKE),
        (wiring.Waiter, "wait", WAIT),
        (physics_node, "run_lock_step", BETWEEN),
        (controller_node, "answer_sets", BETWEEN),
        (metrics_node, "record_ticks", BETWEEN),
    ):
        watch.time(owner, attribute, label)
    connect = wiring.Speaker.__init__

    def connect_timed(speaker: wiring.Speaker, *args: object, **kwargs: object) -> None:
        connect(speaker, *args, **kwargs)  # type: ignore[arg-type]
        speaker.publish = watch.timed(speaker.publish, PUBLISH)

    wiring.Speaker.__init__ = connect_timed  # type: ignore[method-assign,assignment]
