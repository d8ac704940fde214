"""Exact neighbours and the light sensor, against vectors done by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.sensors import SENSORS

Make = Callable[..., Any]


def everybody(robots: int) -> Any:
    """Lists by which everybody may be near everybody else."""
    from cocorosim_ros.world.surroundings.neighbours import Neighbours

    others = [[other for other in range(robots) if other != robot] for robot in range(robots)]
    return Neighbours(np.full((1, robots), robots - 1), np.array([others], np.int32))


def test_place_and_velocity(make_simulation: Make) -> None:
    """Facing north: one 0.3 m east is to the right; it swims north with 0.05 m/s and sinks with 0.01 m/s."""
    from cocorosim_ros.world.sensors.exact_neighbours import exact_neighbours
    from cocorosim_ros.world.state.neighbourhood import empty_neighbourhood

    north = 0.5 * math.pi
    simulation = make_simulation([[[0, 0, -5, north], [0.3, 0.0, -5.2, north], [0.6, 0, -5, 0], [0, -0.5, -5, 0]]])
    simulation.state[0, 1, 4:7] = (0.05, 0.0, -0.01)
    found = empty_neighbourhood(1, 4, 3)
    exact_neighbours(simulation.state, np.array([True, False, False, False]), 0.5, everybody(4), found)
    assert found.found[0].tolist() == [2, 0, 0, 0]
    assert found.who[0, 0, :2].tolist() == [1, 3]  # 2 is too far, 3 exactly within
    np.testing.assert_allclose(found.offset[0, 0, :2], [[0, -0.3, -0.2], [-0.5, 0, 0]], rtol=0, atol=1e-15)
    np.testing.assert_allclose(found.velocity[0, 0, 0], [0, 0.05, -0.01], rtol=0, atol=1e-15)


def test_of_too_many_the_first_are_kept(make_simulation: Make) -> None:
    """With room for two of four the two lowest stand there."""
    from cocorosim_ros.world.sensors.exact_neighbours import exact_neighbours
    from cocorosim_ros.world.state.neighbourhood import empty_neighbourhood

    simulation = make_simulation([np.tile([0.0, 0.0, -5.0, 0.0], (5, 1))])
    found = empty_neighbourhood(1, 5, 2)
    exact_neighbours(simulation.state, np.ones(5, dtype=bool), 0.5, everybody(5), found)
    assert found.who[0, 4].tolist() == [0, 1]
    assert (found.found == 2).all()


@pytest.mark.parametrize(("distance", "expected"), [(0.0, 110.0), (0.7, 10.0 + 100.0 * math.exp(-0.5)), (50.0, 10.0)])
def test_illuminance_of_one_lamp(make_simulation: Make, distance: float, expected: float) -> None:
    """A lamp of 100 lx and 0.7 m width in 10 lx: exp(-1/2) of it one width away."""
    from cocorosim_ros.world.surroundings.lamps import Lamps

    simulation = make_simulation([[[1.0, 2.0 + distance, -5.0, 0.0], [0, 0, -5, 0]]])
    simulation.world = replace(simulation.world, lamps=Lamps(10.0, np.array([[1.0, 2.0, -5.0, 100.0, 0.7]])))
    simulation.world.instruments.measured[0, list(SENSORS).index("illuminance")] = True
    reading = simulation.sense().illuminance
    assert reading[0, 0] == pytest.approx(expected)
    assert math.isnan(reading[0, 1])
