"""The three ways of running a scenario: as processes, composed in one process, without ROS."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rich.console import Console

from cocorosim_ros.commands.missing_package import check_installed, check_ros
from cocorosim_ros.commands.progress import RunProgress
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.between_ticks import steps_of_scenario
from cocorosim_ros.graph.runs.latency import check_latency
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.live.opening import foxglove_port, foxglove_server

if TYPE_CHECKING:
    from cocorosim_ros.commands.rerun_viewer import WaitingViewer
    from cocorosim_ros.graph.nodes.graph import GraphPlan, OpenViewers
    from cocorosim_ros.wire.live.viewers import Viewers


@dataclass(frozen=True)
class Outcome:
    """How a run went."""

    ticks: int
    seconds: float  # of wall clock from the first tick to the last
    starting: float  # s of wall clock until the first tick was done
    interrupted: bool


@dataclass(frozen=True)
class RunChoices:
    """The options of one call."""

    scenario: str
    out: Path | None
    force: bool
    seed: int | None
    duration: str | None
    external: tuple[str, ...]
    controller: str | None
    rate: float
    composed: bool
    in_process: bool
    network: bool
    wait: float
    foxglove: int | None
    json_file: Path | None
    view: bool
    smooth: float
    processes: int | None = None

    def __post_init__(self) -> None:
        """Raise CocorosimError for options that contradict each other."""
        self._check()

    def _check(self) -> None:
        if not 0.0 <= self.rate < math.inf:
            raise CocorosimError(f"--rate has {self.rate:g}; give a positive number, or leave it out for lock-step.")
        if not 0.0 <= self.smooth <= 1000.0:
            raise CocorosimError(f"--smooth has {self.smooth:g}; give Hz up to 1000, or leave it out.")
        if not 0.0 <= self.wait <= 86400.0:
            raise CocorosimError(f"--wait has {self.wait:g}; give seconds from 0 to 86400.")
        if self.composed and self.in_process:
            raise CocorosimError("--composed and --in-process exclude each other; give one of them.")
        if self.processes is not None and self.processes < 1:
            raise CocorosimError(f"--processes has {self.processes}; give a whole number from 1, or leave it out.")
        if (self.composed or self.in_process) and self.processes is not None:
            raise CocorosimError("--composed and --in-process need no processes of controllers; leave out --processes.")
        if (self.composed or self.in_process) and self.rate > 0.0:
            raise CocorosimError("--composed and --in-process run in lock-step; leave out --rate.")


def check_startable(scenario: Scenario, choices: RunChoices) -> None:
    """Nothing, if the scenario can be run so; raises CocorosimError before anything is touched."""
    if (choices.composed or choices.in_process) and scenario.external:
        raise CocorosimError(
            f"The controller of {scenario.external[0]} is left to you, which needs nodes in processes of their own; "
            "leave out --composed and --in-process, or take it out of --external and the scenario's 'external'."
        )
    steps_of_scenario(scenario, choices.smooth, choices.rate)
    if choices.foxglove is not None:
        foxglove_port(choices.foxglove)
    if choices.view:
        check_installed(("rerun",), "leave out --view, and look at the recording with `cocorosim view`")
    if not choices.in_process:
        check_ros("give --in-process, which does the same run without ROS")
        check_latency(scenario)
        _check_environment()
    # Loaded here: what is wrong with options and environment is said before the weight comes.
    from cocorosim_ros.graph.runs.run_record import run_topics, selected_topics
    from cocorosim_ros.graph.runs.scenery import scenery_topics
    from cocorosim_ros.wire.topics.body import describe_body
    from cocorosim_ros.world.controllers.plain.plain_controller import check_plain, rehearse_plain
    from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

    for robot in scenario.robots:
        check_platform(robot.platform)
    check_plain(scenario.robots)
    bodies = [describe_body(robot) for robot in scenario.robots]
    drawn = scenery_topics([body.name for body in bodies])
    selected_topics({**run_topics(bodies), **drawn}, scenario.recording.topics)
    rehearse_plain(scenario.robots, scenario.seed)


def _check_environment() -> None:
    """Raise CocorosimError if variables of the environment ask for a domain or a path that does not exist."""
    from cocorosim_ros.graph.nodes.domain import domain_of_user
    from cocorosim_ros.graph.nodes.path_choice import plain_path_asked

    domain_of_user()
    plain_path_asked()


def run_as_graph(scenario: Scenario, choices: RunChoices, folder: Path, console: Console) -> Outcome:
    """Physics, recorder and controllers as processes."""
    from cocorosim_ros.commands.interruption import Interruption
    from cocorosim_ros.graph.nodes.supervisor import Supervisor
    from cocorosim_ros.graph.runs.warm_up import compile_everything

    with _own_domain(network=choices.network) as domain:
        compile_everything(scenario, _teller(console))
        console.print(_announcement(scenario, domain, choices), markup=False)
        start = time.monotonic()
        viewer = _viewer(choices, console)
        supervisor = Supervisor(_plan(scenario, choices, folder, console, viewer), _warner(console))
        with Interruption() as interruption:
            interruption.then(supervisor.interrupt)
            try:
                supervisor.start()
                with RunProgress(console, scenario, _complaint(viewer)) as progress:
                    supervisor.watch(lambda state: progress.show(state.ticks, state.missing_answers))
            finally:
                supervisor.end()
    state = supervisor.state
    return Outcome(state.ticks, state.seconds, state.starting_after(start), supervisor.interrupted)


def run_in_one_process(scenario: Scenario, choices: RunChoices, folder: Path, console: Console) -> Outcome:
    """All nodes in this process, still on ROS topics."""
    from cocorosim_ros.commands.interruption import Interruption
    from cocorosim_ros.graph.nodes.composed import run_composed
    from cocorosim_ros.graph.runs.warm_up import compile_everything

    compile_everything(scenario, _teller(console))
    with _own_domain(network=choices.network):
        start = time.monotonic()
        viewer = _viewer(choices, console)
        progress = RunProgress(console, scenario, _complaint(viewer))
        with Interruption() as interruption, progress:
            run_composed(
                _plan(scenario, choices, folder, console, viewer),
                lambda graph: interruption.then(graph.physics.request_stop),
                progress.show,
                _warner(console),
            )
    return Outcome(progress.ticks, progress.seconds, progress.starting_after(start), interruption.happened)


def run_without_ros(scenario: Scenario, choices: RunChoices, folder: Path, console: Console) -> Outcome:
    """The same ticks and the same bag, without ROS."""
    from cocorosim_ros.commands.interruption import Interruption
    from cocorosim_ros.graph.runs.in_process import run_in_process
    from cocorosim_ros.graph.runs.warm_up import compile_whole_run
    from cocorosim_ros.library.record import new_record

    compile_whole_run(scenario, _teller(console))
    port, start = _live_port(choices, console), time.monotonic()
    with ExitStack() as stack:
        record = new_record(scenario, folder / "bag", selection=scenario.recording.topics)
        if port is not None:
            record.show_to(stack.enter_context(foxglove_server(port, scenario.name)))
        viewer = _viewer(choices, console)
        scene = _live_scene(scenario, viewer)
        if scene is not None:
            record.show_to(stack.enter_context(scene()))
        interruption = stack.enter_context(Interruption())
        progress = stack.enter_context(RunProgress(console, scenario, _complaint(viewer)))
        stack.enter_context(record.writer)

        def show(tick: int) -> bool:
            progress.show(tick, 0)
            return not interruption.happened

        ticks = run_in_process(scenario, record, show)
    return Outcome(ticks, progress.seconds, progress.starting_after(start), interruption.happened)


@contextmanager
def _own_domain(*, network: bool) -> Iterator[int]:
    """Within, the number of a ROS domain of one's own, for all processes started from here."""
    from cocorosim_ros.graph.nodes.domain import OwnDomain, keep_on_this_machine

    domain = OwnDomain()
    os.environ["ROS_DOMAIN_ID"] = str(domain.number)
    keep_on_this_machine(network=network)
    try:
        yield domain.number
    finally:
        domain.release()


def _plan(
    scenario: Scenario, choices: RunChoices, folder: Path, console: Console, viewer: WaitingViewer | None
) -> GraphPlan:
    from cocorosim_ros.graph.nodes.graph import PROCESSES, GraphPlan

    return GraphPlan(
        scenario,
        choices.scenario,
        folder.resolve(),
        choices.rate,
        choices.wait,
        foxglove=_live_port(choices, console),
        show=_live_scene(scenario, viewer),
        smooth=choices.smooth,
        processes=choices.processes or PROCESSES,
    )


def _viewer(choices: RunChoices, console: Console) -> WaitingViewer | None:
    """Start Rerun's viewer, which is said; None if not asked for."""
    if not choices.view:
        return None
    from cocorosim_ros.commands.rerun_viewer import await_scene

    viewer = await_scene()
    say(console, f"Rerun: {viewer.address}")
    return viewer


def _complaint(viewer: WaitingViewer | None) -> Callable[[], str]:
    return (lambda: "") if viewer is None else viewer.complaint


def _live_scene(scenario: Scenario, viewer: WaitingViewer | None) -> OpenViewers | None:
    """Make the function that opens the scene in a viewer; None without one."""
    if viewer is None:
        return None
    from cocorosim_ros.graph.runs.results import facts_of

    url = viewer.address

    def show() -> AbstractContextManager[Viewers]:
        # Loaded here, in the process that draws: its threads would not survive a fork.
        from cocorosim_ros.study.scene.rerun_live import live_scene

        return live_scene(scenario, facts_of(scenario), url)

    return show


def _live_port(choices: RunChoices, console: Console) -> int | None:
    """Where viewers find the run, which is said; None where nobody asked."""
    if choices.foxglove is None:
        return None
    port = foxglove_port(choices.foxglove)
    say(console, f"Foxglove and Lichtblick: ws://127.0.0.1:{port}")
    return port


def _warner(console: Console) -> Callable[[str], None]:
    return lambda words: console.print(words, style="yellow", markup=False, highlight=False)


def _teller(console: Console) -> Callable[[str], None]:
    return lambda words: say(console, words)


def _announcement(scenario: Scenario, domain: int, choices: RunChoices) -> str:
    where = "on the network" if choices.network else "on this machine only"
    pace = f"at {choices.rate:g} x real time" if choices.rate else "in lock-step"
    words = f"{len(scenario.robots)} robots {pace}, ROS domain {domain}, {where}"
    if scenario.external:
        words += f"\nup to {choices.wait:g} s for the controllers of {', '.join(scenario.external)}; in their shell:"
        words += f"\n  export ROS_DOMAIN_ID={domain}"
        words += "" if choices.network else " ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST"
    return words
