"""A motion that is no number any more ends the run with a sentence, in every kind of run."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.state.state import SURGE, X

TEXT = """
name: two
description: two Lilys
seed: 1
tick: 0.5 s
duration: 5 s
tank: {size: [6 m, 6 m, 2 m]}
integrator: {name: semi_implicit_euler, step: 0.5 s}
swarm:
  - {platform: lily, controller: idle, start: {poses: [[0 m, 0 m, -1 m, 0 deg], [1 m, 0 m, -1 m, 0 deg]]}}
"""


def scenario() -> Any:
    """Two Lilys at rest."""
    from cocorosim_ros.world.checks.loading import parse_scenario

    return parse_scenario(TEXT, "two")


def simulation(first_run: int = 0, runs: int = 1) -> Any:
    """So many runs of them."""
    from cocorosim_ros.world.seeding.seeding import start_poses
    from cocorosim_ros.world.tick.assembly import build_world
    from cocorosim_ros.world.tick.simulation import Simulation

    two = scenario()
    starts = np.stack([start_poses(two, run) for run in range(first_run, first_run + runs)])
    return Simulation(build_world(two, runs, first_run), starts)


@pytest.mark.parametrize(("column", "value"), [(X, math.nan), (SURGE, math.inf)])
def test_who_when_and_what_to_do(column: int, value: float) -> None:
    """The second robot of the second of two runs, after three ticks."""
    swarm = simulation(first_run=7, runs=2)
    for _ in range(2):
        swarm.sense()
        swarm.advance()
    swarm.state[1, 1, column] = value
    with pytest.raises(CocorosimError, match=r"'lily_02' ran away at 1\.5 s .*\(run 8\).* step of 0\.5 s.*shorter"):
        swarm.advance()


def test_two_opposite_infinities_are_found() -> None:
    """They are no number once they are added."""
    swarm = simulation()
    swarm.state[0, :, SURGE] = math.inf, -math.inf
    with pytest.raises(CocorosimError, match="'lily_01' ran away at 0"):
        swarm.advance()


def test_a_batch_has_no_row_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The sentence instead of statistics of what is no number."""
    from cocorosim_ros.study.experiments import batch
    from cocorosim_ros.world.tick.simulation import Simulation

    monkeypatch.setattr(Simulation, "decide", lambda self: self.state.__setitem__((0, 0, X), math.nan))
    with pytest.raises(CocorosimError, match=r"'lily_01' ran away at 0\.5 s"):
        batch.run_batch(scenario(), 0, 1)
    made = batch.run_each(scenario(), 0, 1)
    summary = made.summary
    assert np.isnan([summary.value, summary.mean, summary.median]).all() and list(made.ticks) == [0]
