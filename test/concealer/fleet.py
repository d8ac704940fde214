"""A fleet over weeks: each robot with numbers of its own, a little different on every day; one may lose thrust."""

from __future__ import annotations

import json
import multiprocessing
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from itertools import repeat
from pathlib import Path
from typing import Any

import numpy as np

from concealer import bag, prior
from concealer import layout as at
from concealer.layout import FloatArray
from concealer.prior import Plot
from concealer.recording import instruments, move
from concealer.scene import Faults, Scene
from concealer.sensors import EPOCH_NS, observe
from concealer.staging import SPREAD

WEEK_NS = 7 * 24 * 3600 * 10**9
DAY_NS = 24 * 3600 * 10**9
BY_THE_DAY = (at.DRAG, at.YAW_DRAG, at.THRUST, at.PUMP)
"""What differs a little from day to day: batteries, growth on the hull, warmth of the water."""


@dataclass(frozen=True)
class FleetPlan:
    """What is made: recordings of `robots` in each of `weeks`.

    spread: half-width [1] of the numbers' uniform deviations, a robot's own; scatter: rms [1] of those of a day.
    loser: number of the robot that loses the share `loss` of its thrust a week; -1 for none. duration [s]. noise: rms
    of the water's random force as a fraction of full thrust.
    """

    seed: int
    robots: int
    weeks: int
    loser: int = -1
    loss: float = 0.01
    spread: float = 0.05
    scatter: float = 0.005
    duration: float = 600.0
    noise: float = 0.01


def place(plan: FleetPlan, index: int) -> tuple[int, int]:
    """Week and robot of a recording: a fleet that is made in part has all weeks of some robots."""
    return index % plan.weeks, index // plan.weeks


def name_of(plan: FleetPlan, index: int) -> str:
    """Where recording number `index` lies below the fleet's folder."""
    week, robot = place(plan, index)
    return f"week_{week:02d}/lily_{robot + 1:03d}"


def robot_numbers(plan: FleetPlan, index: int) -> FloatArray:
    """(1, SIZE) the numbers of the robot of a recording on its day."""
    week, robot = place(plan, index)
    numbers = at.nominal_robot()
    own = np.random.default_rng([plan.seed, robot, 0])
    numbers[list(SPREAD)] *= 1.0 + own.uniform(-plan.spread, plan.spread, len(SPREAD))
    day = np.random.default_rng([plan.seed, robot, 1, week])
    numbers[list(BY_THE_DAY)] *= 1.0 + plan.scatter * day.standard_normal(len(BY_THE_DAY))
    if robot == plan.loser:
        numbers[at.THRUST] *= (1.0 - plan.loss) ** week
    return numbers[None]


def make_recording(index: int, plan: FleetPlan, out: Path) -> str:
    """Writes recording number `index` of a fleet, unless it is there; returns its name."""
    name = name_of(plan, index)
    if (out / name / "metadata.yaml").exists():
        return name
    week, robot = place(plan, index)
    drawing, moving, sensing = np.random.default_rng([plan.seed, robot, 2, week]).spawn(3)
    registered: dict[str, Any] = prior.load()
    plot = prior.draw(drawing, registered, prior.Wish("nothing", (), None, plan.noise, 1, "rich", plan.duration))
    scene = Scene(robot_numbers(plan, index), [Faults()], 0)
    _fill(scene, plot, float(registered["tank"]["depth"]))
    rows, commands = move(moving, plot, scene)
    streams = observe(rows[:, 0], commands[:, 0], scene.faults[0], instruments(registered["sensors"], plot), sensing)
    moment = EPOCH_NS + week * WEEK_NS + int(drawing.uniform(0.0, 2.0) * DAY_NS)
    (out / name).parent.mkdir(parents=True, exist_ok=True)
    bag.write(out / name, {f"lily_{robot + 1:03d}": streams}, moment)
    return name


def _fill(scene: Scene, plot: Plot, depth: float) -> None:
    scene.everywhere(half_x=0.5 * plot.side, half_y=0.5 * plot.side, floor=-depth, duration=plot.duration)


def make_fleet(plan: FleetPlan, out: Path, indices: range, jobs: int = 1) -> Iterator[str]:
    """Names of the recordings as they are made; what was planned stands in plan.json beside the folder."""
    out.mkdir(parents=True, exist_ok=True)
    out.with_name(f"{out.name}.json").write_text(json.dumps(asdict(plan), indent=2) + "\n", "utf-8")
    if jobs == 1:
        yield from map(make_recording, indices, repeat(plan), repeat(out))
        return
    with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
        yield from pool.map(make_recording, indices, repeat(plan), repeat(out))
