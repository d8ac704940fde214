"""Spheres and boxes in the water: nobody is inside them, and what is left of the velocity."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

BOUNDS = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
SPHERES = ((1.0, 0.0, -1.0, 0.5), (-1.5, 1.0, -0.6, 0.3))
BOXES = ((-0.5, -2.0, -2.0, 0.5, -1.0, -1.2), (-3.0, -0.4, -1.5, -2.4, 0.4, -0.7))  # one on the floor, one at a wall
Make = Callable[..., Any]


@pytest.fixture
def obstructed(make_simulation: Make) -> Make:
    """Function of (start, and by name contact, steps): a simulation in the tank with these obstacles."""
    return partial(make_simulation, bounds=BOUNDS, spheres=SPHERES, boxes=BOXES)


def clearance(places: Any) -> Any:
    """How far outside of the nearest obstacle each place (n, 3) is [m], negative within (signed distances)."""
    around = [np.linalg.norm(places - sphere[:3], axis=1) - sphere[3] for sphere in np.array(SPHERES)]
    boxes = np.array(BOXES).reshape(-1, 2, 3)
    beside = [np.maximum(low - places, places - high).max(axis=1) for low, high in boxes]
    return np.min([*around, *beside], axis=0)


def coast(simulation: Any, velocity: Any) -> Any:
    """State (8,) after a tick from `velocity` (surge, sway, heave), engines off."""
    simulation.state[0, 0, 4:7] = velocity
    simulation.advance()
    return simulation.state[0, 0, :8]


@pytest.mark.parametrize("contact", ["inelastic", "stop_position"])
def test_nobody_is_inside_an_obstacle(obstructed: Make, contact: str) -> None:
    """200 robots with full random commands for 100 s, without avoidance, stay in the water and touch obstacles."""
    draw = np.random.default_rng(1)
    start = draw.uniform((-3, -3, -2, -4), (3, 3, 0, 4), (1, 2000, 4))
    simulation, touched = obstructed(start[:, clearance(start[0, :, :3]) > 0.0][:, :200], contact=contact), 0
    for tick in range(200):
        if tick % 20 == 0:
            simulation.command[...] = draw.uniform(-1, 1, (1, 200, 3))
        simulation.advance()
        places = simulation.state[0, :, :3]
        free = clearance(places)
        assert free.min() > -1e-12, places[free.argmin()]  # a point put onto a sphere is off by rounding
        assert (places >= BOUNDS[0]).all() and (places <= BOUNDS[1]).all()
        touched += int((free < 1e-9).sum())
    assert touched > 10


def test_head_on_a_sphere_stops_a_robot(obstructed: Make) -> None:
    """On the line to its centre: at the radius, at rest."""
    state = coast(obstructed([[[1.0, -0.51, -1.0, math.pi / 2]]]), (0.07, 0.0, 0.0))
    np.testing.assert_allclose(state[:3], [1.0, -0.5, -1.0], atol=1e-12)
    np.testing.assert_allclose(state[4:7], 0.0, atol=1e-12)


def test_obliquely_on_a_sphere_the_way_along_it_goes_on(obstructed: Make) -> None:
    """What is left of the velocity is tangential: nothing of it is along the radius, and it still goes its way."""
    state = coast(obstructed([[[0.49, 0.05, -0.95, 0.0]]], steps=1), (0.07, 0.0, 0.01))
    radius = (state[:3] - SPHERES[0][:3]) / 0.5
    assert math.isclose(float(radius @ radius), 1.0, abs_tol=1e-12)
    velocity = np.array([state[4], state[5], state[6]])  # yaw is 0: body axes are the world's
    assert abs(float(radius @ velocity)) < 1e-12
    assert state[5] > 0.0 and state[6] > 0.0


@pytest.mark.parametrize(
    ("start", "velocity", "axis", "place"),
    [
        ((-0.51, -1.5, -1.9, 0.0), (0.07, 0.0, 0.0), 0, -0.5),
        ((0.0, -0.99, -1.9, -math.pi / 2), (0.07, 0.0, 0.0), 1, -1.0),
        ((0.0, -1.5, -1.19, 0.3), (0.05, 0.0, -0.05), 2, -1.2),
        ((-2.39, 0.0, -1.0, math.pi), (0.07, 0.0, 0.0), 0, -2.4),
    ],
)
def test_a_box_stops_what_goes_into_its_face(
    obstructed: Make, start: tuple[float, ...], velocity: tuple[float, ...], axis: int, place: float
) -> None:
    """Sides and top: the coordinate stays at the face, and the velocity into the face is lost."""
    state = coast(obstructed([[start]]), velocity)
    assert state[axis] == place
    east = state[4] * math.cos(state[3]) - state[5] * math.sin(state[3])
    north = state[4] * math.sin(state[3]) + state[5] * math.cos(state[3])
    assert (east, north, state[6])[axis] == pytest.approx(0.0, abs=1e-15)
    if axis == 2:
        assert state[4] > 0.04


def test_low_on_a_box_that_stands_on_the_floor(obstructed: Make) -> None:
    """1 mm above the floor and 9 mm into the box the way out is the side, not below the floor."""
    state = coast(obstructed([[[-0.51, -1.5, -1.999, 0.0]]]), (0.07, 0.0, 0.0))
    assert state[0] == -0.5
    assert state[2] == pytest.approx(-1.999, abs=1e-9)


def test_from_an_obstacle_one_can_leave(obstructed: Make) -> None:
    """On a sphere or a face, a robot that swims away is not held."""
    for start in ((1.0, -0.5, -1.0, -math.pi / 2), (-0.5, -1.5, -1.6, math.pi)):
        state = coast(obstructed([[start]]), (0.05, 0.0, 0.0))
        assert state[4] > 0.04
        assert math.hypot(state[0] - start[0], state[1] - start[1]) > 0.02


def test_a_position_stop_keeps_the_velocity(obstructed: Make, make_simulation: Make) -> None:
    """The paper's contact stops the coordinate; the velocity is that of open water."""
    start = [[[1.0, -0.51, -1.0, math.pi / 2]]]
    stopped = coast(obstructed(start, contact="stop_position"), (0.07, 0.0, 0.0))
    free = coast(make_simulation(start), (0.07, 0.0, 0.0))
    assert stopped[1] == pytest.approx(-0.5, abs=1e-12)
    np.testing.assert_allclose(stopped[4:8], free[4:8], rtol=0, atol=1e-15)
