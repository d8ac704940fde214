"""What a node graph consists of, and the ROS arguments of each of its nodes."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

from cocorosim_ros.scenario.reading.quantity import nanoseconds_text
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.live.viewers import Viewers

PROCESSES = 12
"""[processes of controllers] unless asked otherwise. Dozens of participants of DDS cost each other more than a process
for each robot gains: of thirty robots on two cores a tick takes two thirds, of fifty so does starting."""
OpenViewers = Callable[[], AbstractContextManager[Viewers]]


@dataclass(frozen=True)
class GraphPlan:
    """One run of a scenario as a node graph."""

    scenario: Scenario
    source: str  # what `load_scenario` was given
    out: Path  # folder of the run; exists
    rate: float = 0.0  # seconds of simulation per second of wall clock; 0: lock-step
    wait: float = 60.0  # s of wall clock that controllers and recorder get to appear
    foxglove: int | None = None  # port for live viewers; None: nobody
    show: OpenViewers | None = None  # others to whom the recorder shows what it writes
    smooth: float = 0.0  # with a rate: Hz of simulated time of `/clock` and `/tf`; 0: ticks alone
    processes: int = PROCESSES  # at most, of controllers

    @property
    def controlled_here(self) -> list[str]:
        """The robots whose controller belongs to this graph."""
        return [robot.name for robot in self.scenario.robots if not robot.external]

    def physics_arguments(self) -> list[str]:
        """ROS arguments of the physics node."""
        pace = {"rate": float(self.rate), "smooth": float(self.smooth), "wait": float(self.wait)}
        return ros_arguments({"recorded": True, **pace, **self._run()})

    def metrics_arguments(self) -> list[str]:
        """ROS arguments of the metrics node."""
        values = {
            "out": str(self.out / "bag"),
            "summary": str(self.out / "live_metrics.json"),
            "lock_step": self.rate == 0.0,
            "foxglove": -1 if self.foxglove is None else self.foxglove,
            **self._run(),
        }
        return ros_arguments(values)

    def controller_arguments(self, robot: str) -> list[str]:
        """ROS arguments of one robot's controller node, which physics and recorder must hear."""
        values = {"scenario": self.source, "seed": self.scenario.seed, "listeners": 2}
        return [*ros_arguments(values), "-r", f"__ns:=/{robot}"]

    def crews(self) -> list[list[int]]:
        """Numbers of the robots whose controllers belong to this graph, by process; counts differ by one at most."""
        own = [number for number, robot in enumerate(self.scenario.robots) if not robot.external]
        count = min(len(own), self.processes)
        bounds = [len(own) * place // count for place in range(count + 1)] if own else []
        return [own[first:end] for first, end in pairwise(bounds)]

    def _run(self) -> dict[str, Any]:
        external = " ".join(robot.name for robot in self.scenario.robots if robot.external)
        return {
            "scenario": self.source,
            "seed": self.scenario.seed,
            "external": external,
            "duration": nanoseconds_text(self.scenario.duration_ns),
        }


def crew_name(robots: Sequence[str]) -> str:
    """Name of the process that runs the controllers of some robots."""
    return f"controller_{robots[0]}" + (f"_and_{len(robots) - 1}_more" if len(robots) > 1 else "")


def ros_arguments(values: Mapping[str, Any]) -> list[str]:
    """The values as ROS arguments; texts are quoted, because ROS reads values as YAML."""
    arguments = ["--ros-args"]
    for name, value in values.items():
        arguments += ["-p", f"{name}:={json.dumps(value)}"]
    return arguments
