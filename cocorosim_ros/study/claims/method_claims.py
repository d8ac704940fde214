"""Claims about the method: M1 enough runs, M2 currents cost most, M3 large swarms are feasible.

M1 repeats the procedure of results.sample_size on the six metrics of each baseline's runs. M2 compares the wall time
of a robot's tick in the two designs: that of one worker, on a machine that may have been doing other things too, which
is why it asks for more than a factor of two. M3 measures one run here and now, by the clock.
Source: Read et al. 2013, sections 1, 5 and 5.1.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from cocorosim_ros.scenario.parts.swarm import StartBox
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.claims.answers import DASH, NO_RUNS, NOT_DECIDABLE, NOT_REPRODUCED, REPRODUCED, Answer, above
from cocorosim_ros.study.metrics import PAPER_METRICS
from cocorosim_ros.study.results.effect_size import SMALL
from cocorosim_ros.study.results.results import Results
from cocorosim_ros.study.results.sample_size import Consistency, baseline_consistency, median_by_chance
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

RUNS = 400
CROWD, TICKS = 1000, 40
_SUBJECT_M3 = f"{CROWD:,} Lilys (BLT) as dense as eleven in 6 x 6 x 2 m, one run by the clock"


def method_answers(experiments: Mapping[str, Results]) -> Iterator[Answer]:
    """M1 of the designs that are there, M2 where both are, and M3."""
    for results in (experiments[design] for design in ("boids", "turbulence") if design in experiments):
        for numerics in results.numerics:
            yield _enough_runs(results, numerics)
    if {"boids", "turbulence"} <= experiments.keys():
        for numerics in experiments["turbulence"].numerics:
            yield _bottleneck(experiments, numerics)
    yield _crowd_answer()


def _enough_runs(results: Results, numerics: str) -> Answer:
    """M1: with 400 runs, most repetitions of the procedure end below a small effect in all six metrics."""
    subject = f"{results.baseline}: largest of 19 A of {RUNS} runs against others of the same, in six metrics"
    found = {one.runs: one for one in baseline_consistency(results, numerics, PAPER_METRICS)}
    enough = found.get(RUNS)
    verdict = above(0.5, *enough.enough_interval) if enough else NOT_DECIDABLE if found else NO_RUNS
    told = [_told(one) for one in list(found.values())[-2:][::-1]]
    ours = "; ".join([*told, _by_chance(max(found))]) if found else DASH
    return Answer("M1", subject, f"below {SMALL}", numerics, ours, verdict)


def _told(found: Consistency) -> str:
    low, high = (100 * share for share in found.enough_interval)
    return (
        f"{found.runs} runs: {found.median_of_largest:.3f} (median), below {SMALL} in {100 * found.enough:.0f} % "
        f"({low:.0f} to {high:.0f} %) of repetitions"
    )


def _by_chance(runs: int) -> str:
    return f"one continuous metric by chance alone: {median_by_chance(runs):.3f}"


def _bottleneck(experiments: Mapping[str, Results], numerics: str) -> Answer:
    still, moving = (_cost(experiments["boids"], numerics, "BLT"), _cost(experiments["turbulence"], numerics, "T5e-4"))
    ours = f"{1e6 * still:.2g} us without, {1e6 * moving:.2g} us with them"
    verdict = NO_RUNS if math.isnan(still + moving) else REPRODUCED if moving > 2.0 * still else NOT_REPRODUCED
    subject = "wall time of a robot's tick in one worker, BLT and T5e-4"
    return Answer("M2", subject, "currents are the bottleneck", numerics, ours, verdict)


def _cost(results: Results, numerics: str, group: str) -> float:
    """Median wall time of a robot's tick [s]."""
    seconds = results.values(numerics, group, "wall_seconds")
    return float(np.median(seconds) / (results.about["ticks"] * results.about["robots"])) if seconds.size else math.nan


def crowd_scenario() -> Scenario:
    """A thousand Lilys in a tank that is as much larger."""
    scenario = load_scenario("eleven_lilys")
    growth = (CROWD / len(scenario.robots)) ** 0.5
    width, breadth, depth = scenario.tank.size
    tank = replace(scenario.tank, size=(width * growth, breadth * growth, depth))
    group = replace(scenario.swarm[0], count=CROWD)
    box = StartBox((0.0, 0.0, -depth / 2), (width * growth - 1.0, breadth * growth - 1.0, depth - 1.0))
    return replace(scenario, tank=tank, swarm=(replace(group, start=replace(group.start, box=box)),))


def crowd_speed(ticks: int = TICKS) -> float:
    """How many times real time a run of a thousand Lilys goes, compiling left out."""
    scenario = crowd_scenario()
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    began = 0.0
    for tick in range(ticks + 1):
        if tick == 1:
            began = time.perf_counter()
        simulation.sense()
        simulation.decide()
        simulation.advance()
    return ticks * scenario.tick / (time.perf_counter() - began)


def _crowd_answer() -> Answer:
    speed = crowd_speed()
    verdict = REPRODUCED if speed > 1.0 else NOT_REPRODUCED
    return Answer("M3", _SUBJECT_M3, "large swarms are feasible", "both", f"{speed:.2g} times real time", verdict)
