"""A batch is a heap of single runs, and a run is a function of its start."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

TICKS = 30
Make = Callable[..., Any]


@pytest.fixture(scope="module")
def final_state(make_simulation: Make, lily: SimpleNamespace) -> Make:
    """Function of a start (runs, robots, 4): states after 15 s of boids in the paper's tank."""

    def swim(start: Any) -> Any:
        bounds = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
        simulation = make_simulation(start, "boids_blt", lily.boids, bounds=bounds)
        for _ in range(TICKS):
            simulation.sense()
            simulation.decide()
            simulation.advance()
        return simulation.state

    return swim


def test_a_run_among_a_thousand_is_the_run_alone(final_state: Make, crowd: Make) -> None:
    """Bit for bit, first, middle and last of a thousand runs."""
    start = crowd(1000, 11)
    batch = final_state(start)
    for run in (0, 499, 999):
        assert np.array_equal(final_state(start[run : run + 1])[0], batch[run])


def test_a_robot_out_of_reach_makes_no_difference(final_state: Make, crowd: Make) -> None:
    """Five robots and a sixth far away move as five robots do, bit for bit, and the sixth as if alone."""
    five = crowd(1, 5)
    hermit = np.array([[[2.0, 2.0, -1.0, 0.5]]])
    together = final_state(np.concatenate([five, hermit], axis=1))
    assert np.array_equal(together[:, :5], final_state(five))
    assert np.array_equal(together[:, 5:], final_state(hermit))


def test_the_same_start_gives_the_same_run(final_state: Make, crowd: Make) -> None:
    """Twice the same seed, twice the same bits; another seed, another run."""
    once = final_state(crowd(1, 11, seed=7))
    assert np.array_equal(once, final_state(crowd(1, 11, seed=7)))
    assert not np.array_equal(once, final_state(crowd(1, 11, seed=8)))


def test_readings_share_no_memory(make_simulation: Make, crowd: Make) -> None:
    """What an instrument shows is neither the state nor another instrument's array."""
    simulation = make_simulation(crowd(2, 4))
    arrays = [*simulation.sense(), simulation.state, simulation.command, simulation.said, *simulation.inbox]
    for index, one in enumerate(arrays):
        assert not any(np.shares_memory(one, other) for other in arrays[index + 1 :])
    before = simulation.state.copy()
    for reading in simulation.readings:
        reading[...] = -1.0
    assert np.array_equal(simulation.state, before)
