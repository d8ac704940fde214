"""Runs the graph for a chosen time and prints memory, open handles and lost messages of each process over time.

    .venv/bin/python test/benchmark/endurance.py --minutes 12              as fast as it goes, in lock-step
    .venv/bin/python test/benchmark/endurance.py --minutes 120 --rate 1    in real time, free-running

Memory is what a process has for itself (anonymous pages); handles are its open files, sockets and pipes. A message is
lost if its topic has fewer than one a tick in the recording.
"""

from __future__ import annotations

import argparse
import math
import multiprocessing
import os
import tempfile
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from conditions import conditions
from rich.console import Console
from rich.table import Table

from cocorosim_ros.graph.nodes.domain import OwnDomain, keep_on_this_machine
from cocorosim_ros.graph.nodes.graph import GraphPlan
from cocorosim_ros.graph.nodes.shared_state import SharedState
from cocorosim_ros.graph.nodes.supervisor import Supervisor
from cocorosim_ros.graph.runs.run_record import run_topics
from cocorosim_ros.graph.runs.warm_up import compile_everything
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.topics import robot_topic
from cocorosim_ros.world.checks.loading import load_scenario

LONGEST = "100000 h"  # of simulation; the clock on the wall ends it
SETTLED = 0.25  # of the time, after which memory should stand still
WITHOUT_TICKS = {"/diagnostics"}  # topics that speak only when there is something to say


@dataclass(frozen=True)
class Use:
    """What a process has at one moment."""

    memory: float  # MB
    handles: int


@dataclass(frozen=True)
class Moment:
    """The graph at one moment."""

    seconds: float  # of wall clock since the first tick
    ticks: int
    missing: int  # answers that came late or not at all
    uses: Mapping[str, Use]


@dataclass
class Watch:
    """Looks at all processes every so often, and ends the run after a time."""

    every: float  # s
    moments: list[Moment] = field(default_factory=list)
    began: float | None = None

    def look(self, state: SharedState) -> None:
        """Look, if it is time for it and the run is under way."""
        now = time.monotonic()
        if state.ticks == 0:
            return
        self.began = self.began or now
        if not self.moments or now - self.began - self.moments[-1].seconds >= self.every:
            uses = {child.name: use_of(child.pid or 0) for child in multiprocessing.active_children()}
            found = {name: use for name, use in uses.items() if use is not None}
            self.moments.append(Moment(now - self.began, state.ticks, state.missing_answers, found))


def use_of(pid: int) -> Use | None:
    """Memory and handles of a process; None if it is gone."""
    try:
        status = Path(f"/proc/{pid}/status").read_text()
        handles = len(os.listdir(f"/proc/{pid}/fd"))
    except OSError:
        return None
    pages = {line.split(":")[0]: line.split()[1] for line in status.splitlines() if line.startswith("RssAnon")}
    return Use(int(pages["RssAnon"]) / 1024.0, handles) if pages else None


def growth(moments: list[Moment], name: str) -> tuple[float, int]:
    """By how much memory [share] and handles of a process grew between the moment it had settled and the last."""
    having = [moment for moment in moments if name in moment.uses]
    first = next(moment for moment in having if moment.seconds >= SETTLED * having[-1].seconds)
    one, other = first.uses[name], having[-1].uses[name]
    return other.memory / one.memory - 1.0, other.handles - one.handles


def lost(scenario: Scenario, ticks: int, counts: Mapping[str, int]) -> dict[str, int]:
    """How many messages of each topic that speaks every tick are not in the recording."""
    bodies = [describe_body(robot) for robot in scenario.robots]
    silent = WITHOUT_TICKS | {robot_topic(body.name, body.talk) for body in bodies if body.talk and not body.speaks}
    missing = {topic: ticks - counts.get(topic, 0) for topic in run_topics(bodies) if topic not in silent}
    return {topic: count for topic, count in missing.items() if count > 0}


def run(source: str, minutes: float, rate: float, every: float) -> tuple[Scenario, Watch, Path, int, list[str]]:
    """Run the graph for so long on the wall's clock; the recording is complete then."""
    scenario = load_scenario(source, duration=LONGEST)
    domain, watch, complaints = OwnDomain(), Watch(every), list[str]()
    os.environ["ROS_DOMAIN_ID"] = str(domain.number)
    keep_on_this_machine(network=False)
    compile_everything(scenario)
    folder = Path(tempfile.mkdtemp(prefix="endurance_"))
    supervisor = Supervisor(GraphPlan(scenario, source, folder, rate), complaints.append)

    def look(state: SharedState) -> None:
        watch.look(state)
        if watch.began is not None and time.monotonic() - watch.began >= 60.0 * minutes:
            supervisor.interrupt()

    try:
        supervisor.start()
        supervisor.watch(look)
    finally:
        supervisor.end()
        domain.release()
    return scenario, watch, folder, supervisor.state.ticks, complaints


def over_time(console: Console, watch: Watch, tick: float, rows: int) -> None:
    """Memory and handles of the two big processes and of all controllers, at a few moments."""
    table = Table(title="MB and open handles over time", title_justify="left")
    headings = ("wall clock", "simulated", "answers missing", "physics", "recorder", "controllers, most", "all, sum")
    for heading in headings:
        table.add_column(heading, justify="right")
    step = max(1, math.ceil(len(watch.moments) / rows))
    for moment in [*watch.moments[:-1:step], watch.moments[-1]]:
        controllers = [use for name, use in moment.uses.items() if name.startswith("controller_")]
        most = Use(max(use.memory for use in controllers), max(use.handles for use in controllers))
        every = Use(sum(use.memory for use in moment.uses.values()), sum(use.handles for use in moment.uses.values()))
        shown = [moment.uses["physics_node"], moment.uses["metrics_node"], most, every]
        times = [f"{moment.seconds / 60.0:.1f} min", f"{moment.ticks * tick / 3600.0:.2f} h", str(moment.missing)]
        table.add_row(*times, *(f"{use.memory:.1f}, {use.handles}" for use in shown))
    console.print(table)


def main() -> None:
    """Run, and print what was seen."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, required=True, help="of wall clock")
    parser.add_argument("--rate", type=float, default=0.0, help="seconds of simulation per second; default: lock-step")
    parser.add_argument("--scenario", default="eleven_lilys")
    parser.add_argument("--every", type=float, default=15.0, help="seconds between looks")
    parser.add_argument("--rows", type=int, default=10, help="moments in the table")
    chosen = parser.parse_args()
    console = Console(width=140, highlight=False)
    for line in conditions():
        console.print(line)
    scenario, watch, folder, ticks, complaints = run(chosen.scenario, chosen.minutes, chosen.rate, chosen.every)
    over_time(console, watch, scenario.tick, chosen.rows)
    grown = {name: growth(watch.moments, name) for name in watch.moments[-1].uses}
    controllers = [name for name in grown if name.startswith("controller_")]
    for name in ("physics_node", "metrics_node", max(controllers, key=lambda name: grown[name])):
        share, handles = grown[name]
        of_all = ", the most of all controllers" if name in controllers else ""
        console.print(
            f"{name}: memory {100.0 * share:+.1f} %, handles {handles:+d} after a quarter of the time{of_all}"
        )
    summary = read_bag(folder / "bag").summary
    missing = lost(scenario, ticks, summary.counts)
    size = sum(file.stat().st_size for file in (folder / "bag").iterdir()) / 1e6
    console.print(
        f"{ticks} ticks, {ticks * scenario.tick / 3600.0:.2f} h simulated, {chosen.minutes:g} min of wall clock"
    )
    console.print(
        f"{summary.message_count} messages recorded, {sum(missing.values())} lost, {size:.0f} MB: {missing or 'none'}"
    )
    console.print(f"complaints: {complaints or 'none'}")
    console.print(f"the recording is {folder / 'bag'}")


if __name__ == "__main__":
    main()
