"""What every entry of CURRENTS has to keep, unasked."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.currents import VELOCITY_CURRENTS
from cocorosim_ros.world.water.currents import CURRENTS
from cocorosim_ros.world.water.flow import add_water_velocity, make_flow

every_current = pytest.mark.parametrize("name", CURRENTS)
TABLES = ("gridded", "ocean")
GRID_AXES = [np.array([0.0, 10.0]), np.array([-2.0, -0.5, 0.0]), np.linspace(-3.0, 3.0, 4), np.linspace(-3.0, 3.0, 5)]


def numbers_of(name: str) -> Any:
    """Numbers of a current: its parameters from 0.05 upwards, or a small random table."""
    if name == "waves":  # one of 2.6 s in 2 m of water, along +x
        return np.array([2.0, 0.05, 2.4, 0.7, 0.7, 0.0, 0.3])
    if name not in TABLES:
        return 0.05 * np.arange(1.0, 1.0 + len(CURRENTS[name].parameters))
    sizes = [len(axis) for axis in GRID_AXES]
    table = np.random.default_rng(1).normal(0.0, 0.1, (*sizes, 3))
    return np.concatenate([sizes, *GRID_AXES, table.ravel()])


def velocity(name: str, place: Any, time: float) -> Any:
    """Velocity (3,) of one current by itself."""
    total = np.zeros(3)
    CURRENTS[name].velocity(np.asarray(place, dtype=float), time, numbers_of(name), total)
    return total


@every_current
def test_it_is_finite_and_moves(name: str) -> None:
    """Anywhere in a tank at any time the velocity is finite, and somewhere it is not zero."""
    places = np.random.default_rng(2).uniform([-3, -3, -2], [3, 3, 0], (200, 3))
    all_of_it = np.array([velocity(name, place, 7.3 * k) for k, place in enumerate(places)])
    assert np.isfinite(all_of_it).all() and all_of_it.any()


@every_current
def test_it_adds(name: str) -> None:
    """Two currents in one flow are the sum of both."""
    place, time, total = np.array([0.3, -1.2, -0.7]), 3.0, np.zeros(3)
    add_water_velocity(place, time, make_flow([(name, numbers_of(name)), ("uniform", np.array([0.5, -2.0]))]), total)
    alone = velocity(name, place, time)
    np.testing.assert_allclose(total - alone, [0.5, -2.0, 0.0], rtol=0, atol=1e-15)


@pytest.mark.parametrize("name", [name for name in CURRENTS if name not in TABLES])
def test_it_is_free_of_divergence(name: str) -> None:
    """Water neither appears nor vanishes: the central difference of the divergence is zero."""
    step = 1e-4
    for place in np.random.default_rng(3).uniform([-3, -3, -2], [3, 3, 0], (50, 3)):
        slopes = [
            (velocity(name, place + e, 1.0)[axis] - velocity(name, place - e, 1.0)[axis]) / (2 * step)
            for axis, e in enumerate(step * np.eye(3))
        ]
        assert abs(sum(slopes)) < 1e-7


@every_current
def test_a_scenario_can_ask_for_it(name: str) -> None:
    """Its parameters are fields of the scenario's record of that name, and its function has its name."""
    fields = {field.name for field in dataclasses.fields(VELOCITY_CURRENTS[name])}
    assert set(CURRENTS[name].parameters) <= fields
    assert CURRENTS[name].velocity.__name__ == name
    assert CURRENTS[name].summary
    assert list(CURRENTS) == list(VELOCITY_CURRENTS)


@every_current
def test_nowhere_faster_than_it_says(name: str) -> None:
    """At random places and times of a tank, and it does get at least half as fast somewhere: no idle bound."""
    size = (6.0, 6.0, 2.0)
    said = CURRENTS[name].fastest(numbers_of(name), size)
    random = np.random.default_rng(3)
    places = random.uniform([-3, -3, -2], [3, 3, 0], (4000, 3))
    speeds = [np.linalg.norm(velocity(name, place, random.uniform(0.0, 60.0))) for place in places]
    assert 0.5 * said < max(speeds) <= said * (1.0 + 1e-12)
