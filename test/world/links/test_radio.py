"""Radio: who hears whom, in which order, and how many."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

Make = Callable[..., Any]


def hear(places: Any, spoken: Any = None, reach: float | Any = 0.5, capacity: int | None = None) -> list[list[int]]:
    """For each robot of one run, the senders that it hears; robot i says the number i + 1."""
    from cocorosim_ros.world.links.radio import deliver
    from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, empty_inbox
    from cocorosim_ros.world.surroundings.neighbours import NeighbourSearch
    from cocorosim_ros.world.surroundings.tank import Tank

    places = np.asarray(places, dtype=float)
    robots = len(places)
    state, said = np.zeros((1, robots, 11)), np.zeros((1, robots, MESSAGE_SIZE))
    state[0, :, :3] = places
    said[0, :, MESSAGE_LENGTH] = np.ones(robots) if spoken is None else spoken
    said[0, :, 1] = np.arange(robots) + 1
    inbox = empty_inbox(1, robots, capacity or robots)
    tank = Tank(np.full(3, -9.0), np.full(3, 9.0), np.zeros((0, 4)), np.zeros((0, 6)))
    neighbours = NeighbourSearch(1, robots, tank, float(np.max(reach))).find(state)
    deliver(state, said, np.broadcast_to(reach, robots).astype(float), neighbours, inbox, None)
    heard = [inbox.sender[0, i, : inbox.heard[0, i]].tolist() for i in range(robots)]
    for i, senders in enumerate(heard):
        assert inbox.message[0, i, : len(senders), 1].tolist() == [sender + 1 for sender in senders]
    return heard


def test_range_is_inclusive() -> None:
    """At exactly 0.5 m a message is heard, a nanometre further it is not."""
    assert hear([(0, 0, -1), (0.5, 0, -1)]) == [[1], [0]]
    assert hear([(0, 0, -1), (0.5 + 1e-9, 0, -1)]) == [[], []]


def test_range_counts_in_three_dimensions() -> None:
    """0.3 m aside and 0.4 m below are 0.5 m; 0.41 m below are too far."""
    assert hear([(0, 0, -1), (0, 0.3, -1.4)]) == [[1], [0]]
    assert hear([(0, 0, -1), (0, 0.3, -1.41)]) == [[], []]


def test_nobody_hears_himself_nor_the_silent() -> None:
    """Three together, the middle one silent: it hears both, they hear each other."""
    assert hear([(0, 0, -1), (0.1, 0, -1), (0.2, 0, -1)], spoken=[1, 0, 1]) == [[2], [0, 2], [0]]


def test_senders_stand_in_ascending_order() -> None:
    """Wherever they swim, messages stand in the order of the senders."""
    places = np.random.default_rng(0).permutation(8)[:, None] * [0.05, 0, 0]
    assert hear(places) == [[j for j in range(8) if j != i] for i in range(8)]


def test_hearing_is_mutual(crowd: Make) -> None:
    """With one range for all, a robot that one hears hears it too; and it is those within 0.5 m."""
    places = crowd(1, 40, seed=2)[0, :, :3] * [2, 2, 1]
    heard = hear(places)
    near = np.linalg.norm(places[:, None] - places, axis=-1) <= 0.5
    assert heard == [[j for j in range(40) if near[i, j] and j != i] for i in range(40)]
    assert all(i in heard[j] for i in range(40) for j in heard[i])


def test_the_senders_range_counts() -> None:
    """A loud robot is heard by a quiet one at 1 m, not the other way round."""
    assert hear([(0, 0, -1), (1, 0, -1)], reach=[2.0, 0.5]) == [[], [0]]


def test_a_full_inbox_keeps_the_first() -> None:
    """With room for three, the three lowest senders are kept."""
    assert hear(np.zeros((6, 3)), capacity=3) == [[1, 2, 3], [0, 2, 3], [0, 1, 3]] + [[0, 1, 2]] * 3


@pytest.mark.parametrize("ticks", [1, 2, 5])
def test_a_message_takes_one_tick(make_simulation: Make, lily: SimpleNamespace, ticks: int) -> None:
    """What is said at tick k stands in the inbox at tick k + 1, with the velocity of tick k."""
    start = [[[0.0, 0.0, -5.0, 0.3], [0.3, 0.1, -5.1, 2.0]]]
    simulation = make_simulation(start, "boids_blt", lily.boids)
    assert simulation.inbox.heard.tolist() == [[0, 0]]
    for _ in range(ticks):
        simulation.sense()
        simulation.decide()
        said_from = simulation.state.copy()
        simulation.advance()
    assert simulation.inbox.heard.tolist() == [[1, 1]]
    yaw, (surge, sway, heave) = said_from[0, 1, 3], said_from[0, 1, 4:7]
    east, north = surge * np.cos(yaw) - sway * np.sin(yaw), surge * np.sin(yaw) + sway * np.cos(yaw)
    np.testing.assert_allclose(simulation.inbox.message[0, 0, 0, :4], [3, east, north, heave], rtol=0, atol=1e-15)
