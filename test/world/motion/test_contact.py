"""Walls, floor and surface: nobody leaves the water, and what is left of the velocity."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

BOUNDS = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
Make = Callable[..., Any]


def coast(simulation: Any, velocity: Any) -> Any:
    """State (8,) after a tick from `velocity` (surge, sway, heave), engines off."""
    simulation.state[0, 0, 4:7] = velocity
    simulation.advance()
    return simulation.state[0, 0, :8]


@pytest.mark.parametrize("contact", ["inelastic", "stop_position"])
def test_nobody_leaves_the_tank(make_simulation: Make, contact: str) -> None:
    """200 robots with full random commands for 100 s, without avoidance, stay within the walls."""
    draw = np.random.default_rng(1)
    start = draw.uniform((-3, -3, -2, -4), (3, 3, 0, 4), (1, 200, 4))
    simulation, touched = make_simulation(start, bounds=BOUNDS, contact=contact), False
    for tick in range(200):
        if tick % 20 == 0:
            simulation.command[...] = draw.uniform(-1, 1, (1, 200, 3))
        simulation.advance()
        places = simulation.state[0, :, :3]
        assert (places >= BOUNDS[0]).all() and (places <= BOUNDS[1]).all()
        touched |= bool((places == BOUNDS[1]).any())
    assert touched


def test_an_inelastic_wall_takes_the_velocity_into_it(make_simulation: Make) -> None:
    """Oblique to the east wall: the way along the wall goes on, the way into it ends."""
    yaw = math.radians(60.0)
    state = coast(make_simulation([[[2.999, 0.0, -1.0, yaw]]], bounds=BOUNDS), (0.07, 0.0, 0.0))
    east = state[4] * math.cos(yaw) - state[5] * math.sin(yaw)
    north = state[4] * math.sin(yaw) + state[5] * math.cos(yaw)
    assert state[0] == 3.0
    assert east == pytest.approx(0.0, abs=1e-15)
    along = 0.07 * math.sin(yaw)  # slowed by the drag of a total speed between this and 0.07 m/s
    assert along / (1 + 1.7778 * 0.07 * 0.5 / 0.44) < north < along / (1 + 1.7778 * along * 0.5 / 0.44)


def test_a_position_stop_keeps_the_velocity(make_simulation: Make) -> None:
    """The paper's wall stops the coordinate; the velocity is that of open water."""
    start = [[[2.999, 0.0, -1.0, 0.4]]]
    walled = coast(make_simulation(start, bounds=BOUNDS, contact="stop_position"), (0.07, 0.01, 0.0))
    free = coast(make_simulation(start), (0.07, 0.01, 0.0))
    assert walled[0] == 3.0
    assert free[0] > 3.0
    np.testing.assert_allclose(walled[4:8], free[4:8], rtol=0, atol=1e-15)


def test_floor_and_surface_stop_heave_alone(make_simulation: Make) -> None:
    """On the floor and at the surface heave is zero and surge goes on."""
    for z, heave, stop in ((-1.99, -0.1, -2.0), (-0.01, 0.1, 0.0)):
        state = coast(make_simulation([[[0.0, 0.0, z, 1.0]]], bounds=BOUNDS), (0.05, 0.0, heave))
        assert state[2] == stop
        assert state[6] == 0.0
        assert state[4] > 0.04


def test_from_the_wall_one_can_leave(make_simulation: Make) -> None:
    """A robot at the wall that swims away from it is not held."""
    state = coast(make_simulation([[[3.0, 0.0, -1.0, math.pi]]], bounds=BOUNDS), (0.05, 0.0, 0.0))
    assert state[0] < 2.98
    assert state[4] > 0.04
