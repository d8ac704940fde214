"""Runs of one cell, many at once: the same ticks and the same statistics as each of them alone."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.scenario.parts.water import patch_counts
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.metrics.kernel import measure_tick
from cocorosim_ros.study.metrics.memory import new_memory
from cocorosim_ros.study.metrics.summary import Summary, summarise
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.state import YAW, X, Z
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.divergence import RanAwayError
from cocorosim_ros.world.tick.simulation import Simulation

_BYTES_PER_CHUNK = 300e6
_MOST_PER_CHUNK = 50
# Forces on patches are gone through at every tick: those of a few runs stay in the processor's caches.
_BYTES_OF_WATER = 4e6


@dataclass(frozen=True)
class RunsMade:
    """What has come of some runs of one cell."""

    summary: Summary
    """NaN for a run whose motion ran away."""
    ticks: Integers
    """(runs,) how many each has made: fewer than the scenario has if its motion ran away."""


def runs_that_fit(scenario: Scenario) -> int:
    """How many runs of a scenario are worth calculating at once.

    Their series of values have to fit in memory, the water of all of them near the processor.
    """
    most = min(_MOST_PER_CHUNK, _BYTES_PER_CHUNK / (scenario.ticks * len(METRICS) * 8))
    if scenario.water is not None and scenario.water.force_currents is not None:
        patches = math.prod(patch_counts(scenario.tank.size, scenario.water.force_currents.patch))
        most = min(most, _BYTES_OF_WATER / (3 * 8 * patches))
    return max(1, int(most))


def run_each(scenario: Scenario, first: int, count: int) -> RunsMade:
    """The runs `first` to `first + count - 1`; if the motion of one runs away, the others are what they are without."""
    try:
        return RunsMade(run_batch(scenario, first, count), np.full(count, scenario.ticks))
    except RanAwayError as error:
        if count == 1:
            nothing = np.full((1, len(METRICS)), np.nan)
            summary = Summary(nothing, nothing, nothing, np.zeros((1, len(METRICS)), np.int64))
            return RunsMade(summary, np.array([error.ticks]))
    half = count // 2
    return _joined(run_each(scenario, first, half), run_each(scenario, first + half, count - half))


def _joined(before: RunsMade, after: RunsMade) -> RunsMade:
    names = [part.name for part in fields(Summary)]
    parts = (np.concatenate([getattr(made.summary, name) for made in (before, after)]) for name in names)
    return RunsMade(Summary(*parts), np.concatenate([before.ticks, after.ticks]))


def run_batch(scenario: Scenario, first: int, count: int) -> Summary:
    """Summaries of the runs `first` to `first + count - 1` of a scenario. Raises RanAwayError if one runs away."""
    starts = np.stack([start_poses(scenario, run) for run in range(first, first + count)])
    simulation = Simulation(build_world(scenario, count, first), starts)
    values = np.empty((scenario.ticks, count, len(METRICS)))
    observer = _Observer(scenario, count)
    for tick in range(scenario.ticks):
        simulation.sense()
        simulation.decide()
        observer.measure(simulation.state, values[tick])
        simulation.advance()
    return summarise(values)


class _Observer:
    """Measures all runs at every tick, robots in the order of their names as in a recording."""

    def __init__(self, scenario: Scenario, runs: int) -> None:
        names = [robot.name for robot in scenario.robots]
        order = sorted(range(len(names)), key=lambda robot: names[robot])
        self._order: Integers | None = None if order == list(range(len(names))) else np.array(order)
        self._memory = new_memory(runs, len(names))
        self._position = np.empty((runs, len(names), 3))
        self._yaw = np.empty((runs, len(names)))
        self._present = np.ones((runs, len(names)), np.bool_)
        self._elapsed = np.zeros(runs, np.int64)
        self._tick_ns = scenario.tick_ns

    def measure(self, state: Floats, values: Floats) -> None:
        """Write every metric of every run into `values` (runs, metrics)."""
        seen = state if self._order is None else state[:, self._order]
        self._position[...] = seen[..., X : Z + 1]
        self._yaw[...] = seen[..., YAW]
        measure_tick(self._position, self._yaw, self._present, self._elapsed, self._memory, values)
        self._elapsed[:] = self._tick_ns
