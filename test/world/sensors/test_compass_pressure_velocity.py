"""Compass, pressure sensor and velocity estimate by the contract's conventions."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.sensors import SENSORS

Make = Callable[..., Any]


@pytest.mark.parametrize(
    ("yaw", "heading"),
    [
        (0.0, 0.0),
        (1.0, 1.0),
        (math.pi, math.pi),
        (-math.pi, math.pi),
        (math.pi + 0.1, -math.pi + 0.1),
        (-math.pi - 0.1, math.pi - 0.1),
        (7.0 * math.pi, math.pi),
        (20.0 * math.pi + 0.5, 0.5),
        (-9.5 * math.pi, 0.5 * math.pi),
    ],
)
def test_compass_reads_in_minus_pi_to_pi(make_simulation: Make, yaw: float, heading: float) -> None:
    """The heading is the yaw less whole turns; straight west is +pi."""
    reading = make_simulation([[[0.0, 0.0, -1.0, yaw]]]).sense().compass[0, 0]
    assert reading == pytest.approx(heading, abs=1e-12)
    assert -math.pi < reading <= math.pi


def test_pressure_is_that_of_air_and_water_above(make_simulation: Make) -> None:
    """101325 Pa at the surface and 9810 Pa more for each metre."""
    start = [[[0.0, 0.0, z, 0.0] for z in (0.0, -1.0, -2.0)]]
    assert make_simulation(start).sense().pressure[0].tolist() == [101325.0, 111135.0, 120945.0]


def test_velocity_is_the_bodys_own(make_simulation: Make) -> None:
    """Surge, sway, heave and yaw rate as they are."""
    simulation = make_simulation([[[0.0, 0.0, -1.0, 2.0]]])
    simulation.state[0, 0, 4:8] = (0.05, -0.01, 0.02, 0.3)
    assert simulation.sense().velocity[0, 0].tolist() == [0.05, -0.01, 0.02, 0.3]


def test_velocity_is_nan_where_it_is_not_measured(make_simulation: Make) -> None:
    """A robot without the estimate shows NaN in all four, its fellow is not concerned."""
    simulation = make_simulation([[[0.0, 0.0, -1.0, 0.0], [1.0, 0.0, -1.0, 0.0]]])
    simulation.world.instruments.measured[0, list(SENSORS).index("velocity")] = False
    velocity = simulation.sense().velocity[0]
    assert np.isnan(velocity[0]).all()
    assert velocity[1].tolist() == [0.0] * 4
