"""The work that is timed in water that moves: the paper's forces on patches, and velocities."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from swarms import Pace, batches, in_tank_of, pace_of

from cocorosim_ros.scenario.parts.currents import TidalCurrent, VortexCurrent
from cocorosim_ros.scenario.parts.water import Water
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.experiments.batch import run_batch, runs_that_fit
from cocorosim_ros.study.experiments.design import load_design
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.water.force_field.force_field import ForceField

LARGE_THREADS = 2  # cores on which the parts of a large field go side by side
RUNS_AT_ONCE = 3  # a thread; as many as an experiment takes


def turbulent(numerics: str = "accurate") -> Scenario:
    """Eleven Lilys in 50,000 patches with cold spots of 0.0005 N and wakes: a cell of the design `turbulence`."""
    (cell,) = load_design("turbulence", groups=["T5e-4"], numerics=[numerics]).cells
    return cell.scenario


def many_runs_in_patches(cores: int) -> tuple[Pace, Simulation]:
    """The pace of some runs in every thread, and one of the batches."""
    made = batches(turbulent(), RUNS_AT_ONCE * cores, cores)
    return pace_of(made, 150), made[0]


def one_run_in_patches(robots: int) -> tuple[Pace, Simulation]:
    """One run of a large swarm at the paper's density in patches, its forces on two cores."""
    (simulation,) = batches(in_tank_of(turbulent(), robots), 1, 1)
    return replace(pace_of([simulation], 8, 2), threads=LARGE_THREADS), simulation


def one_run_in_flow(robots: int) -> tuple[Pace, Simulation]:
    """The same where the water has velocities: a vortex and a tide."""
    currents = (VortexCurrent(x=0.0, y=0.0, circulation=0.1, core=2.0), TidalCurrent(x=0.01, y=0.0, period=600.0))
    scenario = replace(in_tank_of(turbulent(), robots), water=Water(currents=currents))
    (simulation,) = batches(scenario, 1, 1)
    return pace_of([simulation], 60), simulation


def field_times(field: ForceField) -> dict[str, float]:
    """Processor seconds of the parts of one step of a field, the least of many."""
    pulling = field.pulling()
    assert pulling is not None
    copy, sums = np.zeros_like(field.water), np.zeros_like(field.water)
    return {
        "copy": least(lambda: np.copyto(copy, field.water)),
        "sum of two fields": least(lambda: np.add(field.water, copy, out=sums)),
        "diffusion and decay": least(field.spread),
        "the same with cold spots": least(lambda: field.spread_and_pull(pulling)),
    }


def least(work: Callable[[], object], repeats: int = 300) -> float:
    """The least processor time [s] of some repetitions."""
    times = []
    for _ in range(repeats):
        began = time.thread_time()
        work()
        times.append(time.thread_time() - began)
    return min(times)


def design_minutes(name: str, cores: int) -> float:
    """Minutes that a whole design takes on `cores`, from a sample of every cell: two lengths of some runs."""
    design, seconds = load_design(name), 0.0
    for cell in design.cells:
        runs, spent = runs_that_fit(cell.scenario), []
        for ticks in (20, 20, 120):
            scenario = replace(cell.scenario, duration_ns=ticks * cell.scenario.tick_ns)
            began = time.thread_time()
            run_batch(scenario, 0, runs)
            spent.append(time.thread_time() - began)
        seconds += (spent[2] - spent[1]) / 100 / runs * cell.scenario.ticks * design.replicates
    return seconds / cores / 60
