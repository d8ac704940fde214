"""Who is near whom: the lists hold everybody within reach, however they were found."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

Make = Callable[..., Any]


def lists_of(places: Any, reach: float, tank: Any) -> list[list[list[int]]]:
    """For every run and robot the neighbours found; `places` (runs, robots, 3)."""
    from cocorosim_ros.world.surroundings.neighbours import NeighbourSearch

    found = NeighbourSearch(*places.shape[:2], tank, reach).find(places)
    runs, robots = places.shape[:2]
    return [[found.who[r, i, : found.near[r, i]].tolist() for i in range(robots)] for r in range(runs)]


@pytest.mark.parametrize(
    ("robots", "reach"), [(1, 0.5), (2, 0.5), (30, 0.5), (48, 0.9), (49, 0.9), (400, 0.5), (400, 3.0)]
)
def test_everybody_within_reach_is_listed_in_ascending_order(robots: int, reach: float, make_tank: Make) -> None:
    """Few robots or many, the lists are those of distances by numpy, also at walls and when all are near."""
    bounds = ((-3.0, -2.0, -2.0), (3.0, 2.0, 0.0))
    places = np.random.default_rng(robots).uniform(*bounds, (3, robots, 3))
    places[:, : robots // 4, 0] = 3.0
    distance = np.linalg.norm(places[:, :, None] - places[:, None], axis=-1)
    near = (distance <= reach) & ~np.eye(robots, dtype=bool)
    expected = [[np.flatnonzero(row).tolist() for row in run] for run in near]
    assert lists_of(places, reach, make_tank(bounds)) == expected


def test_robots_beyond_the_walls_are_found_too(make_tank: Make) -> None:
    """The cells at the border take in who is outside of the tank; who is nowhere is near nobody."""
    tank = make_tank(((-1.0, -1.0, -1.0), (1.0, 1.0, 0.0)))
    places = np.zeros((1, 60, 3))
    places[0, :, 0] = np.arange(60) * 10.0
    places[0, 59] = np.nan
    expected = [[j for j in (i - 1, i + 1) if 0 <= j < 59] for i in range(59)] + [[]]
    assert lists_of(places, 10.0, tank) == [expected]


def test_a_swarm_in_cells_swims_as_one_compared_pair_by_pair(
    make_simulation: Make, lily: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
) -> None:
    """200 boids swim the same bits with cells and without."""
    from cocorosim_ros.world.surroundings import neighbours

    def swim() -> Any:
        draw = np.random.default_rng(5)
        start = draw.uniform([-1.5, -1.5, -1.9, -3.1], [1.5, 1.5, -0.6, 3.1], (2, 200, 4))
        simulation = make_simulation(start, "boids_blt", lily.boids, bounds=((-2.0, -2.0, -2.0), (2.0, 2.0, 0.0)))
        for _ in range(40):
            simulation.sense()
            simulation.decide()
            simulation.advance()
        return simulation

    celled = swim()
    monkeypatch.setattr(neighbours, "GRID_FROM", 1000)
    paired = swim()
    assert paired._search._gridded is False and celled._search._gridded is True
    assert np.array_equal(celled.state, paired.state)
    assert np.array_equal(celled.inbox.heard, paired.inbox.heard)


def test_open_water_never_hides_a_solid(make_tank: Make) -> None:
    """Wherever open water is claimed, no ray in any direction ends within reach; and it is claimed at times."""
    from cocorosim_ros.world.surroundings.tank import is_open_water, ray_range

    tank = make_tank(
        ((-2.0, -2.0, -2.0), (2.0, 2.0, 0.0)),
        [(0.5, 0.5, -1.0, 0.3)],
        [(-1.0, -1.0, -2.0, -0.5, -0.5, -0.8)],
    )
    draw, claims = np.random.default_rng(3), 0
    for place in draw.uniform([-2, -2, -2], [2, 2, 0], (500, 3)):
        rays = draw.normal(size=(20, 3))
        nearest = min(ray_range(tank, place, ray / np.linalg.norm(ray), math.inf) for ray in rays)
        claimed = is_open_water(tank, place, 0.3)
        claims += claimed
        assert nearest > 0.3 or not claimed
    assert 100 < claims < 450
