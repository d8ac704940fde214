"""Obstacle avoidance: nobody touches wall, floor or surface, and the thresholds are the system's."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

BOUNDS = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
Make = Callable[..., Any]


def run(simulation: Any, ticks: int) -> Any:
    """Places (ticks, robots, 3) of the first run after each tick."""
    places = []
    for _ in range(ticks):
        simulation.sense()
        simulation.decide()
        simulation.advance()
        places.append(simulation.state[0, :, :3].copy())
    return np.array(places)


def request_at(make_simulation: Make, place: Any, yaw: float, settings: Any = (0.0, 1.0, 1.0, 3.0)) -> Any:
    """Simulation after one cycle of heading_hold at `place`, and its request."""
    simulation = make_simulation([[[*place, yaw]]], "heading_hold", settings, bounds=BOUNDS)
    simulation.sense()
    simulation.decide()
    return simulation, simulation.memory[0, 0]


@pytest.mark.parametrize(
    ("place", "yaw", "away"),
    [
        ((2.8, 0.0, -1.0), 0.0, math.pi),  # wall ahead: both front sensors, back out
        ((2.8, 0.0, -1.0), math.pi, math.pi),  # wall behind: the back sensor, straight on
        ((0.0, 2.8, -1.0), 0.0, -math.pi / 3),  # wall on the left: front left and back, 60 degrees off
        ((0.0, -2.8, -1.0), 0.0, math.pi / 3),
    ],
)
def test_away_from_a_wall(make_simulation: Make, place: Any, yaw: float, away: float) -> None:
    """20 cm from a wall it heads away along the sum of the sensors' axes, with 50 % thrust at gain 15."""
    from cocorosim_ros.world.controllers.request import HEADING, SPEED, TURN_GAIN

    _, request = request_at(make_simulation, place, yaw, (yaw, 1.0, 1.0, 3.0))
    assert math.cos(request[HEADING] - away) == pytest.approx(1.0, abs=1e-12)
    assert (request[SPEED], request[TURN_GAIN]) == (0.5, 15.0)


def test_thrusters_in_front_of_a_wall(make_simulation: Make) -> None:
    """Wall ahead: 5 * 15 * pi = 235.6 counts of turn around 63.5; 54.3 of the one side go off the other."""
    simulation, _ = request_at(make_simulation, (2.8, 0.0, -1.0), 0.0)
    turn = 0.5 * 75.0 * math.pi
    slow, fast = 63.5 - turn - (63.5 + turn - 127.0), 127.0
    np.testing.assert_allclose(sorted(simulation.command[0, 0, :2] * 127.5), [slow, fast], rtol=0, atol=1e-9)


@pytest.mark.parametrize(("clearance", "avoids"), [(0.2499, True), (0.2501, False)])
def test_wall_threshold(make_simulation: Make, clearance: float, avoids: bool) -> None:
    """Nearer than 25 cm avoidance acts and the behaviour does not; further away it is the other way round."""
    from cocorosim_ros.world.controllers.request import SPEED

    _, request = request_at(make_simulation, (3.0 - clearance, 0.0, -1.0), 0.0)
    assert request[SPEED] == (0.5 if avoids else 1.0)


@pytest.mark.parametrize(
    ("depth", "target"),
    [(0.49, 0.6), (0.51, None), (1.79, None), (1.81, 1.7), (1.95, 1.7)],
)
def test_floor_and_surface_thresholds(make_simulation: Make, depth: float, target: float | None) -> None:
    """Above 0.5 m the target is 0.6 m; less than 0.2 m over the floor it is 0.3 m over it."""
    from cocorosim_ros.world.controllers.request import DIVE, DIVE_MODE, DIVE_TO_DEPTH

    _, request = request_at(make_simulation, (0.0, 0.0, -depth), 0.0, (0.0, 1.0, 1.234, 3.0))
    assert request[DIVE_MODE] == DIVE_TO_DEPTH
    assert request[DIVE] == pytest.approx(1.234 if target is None else target, abs=1e-9)


@pytest.mark.parametrize("choice", [{}, {"integrator": "semi_implicit_euler", "steps": 1}])
def test_driven_at_a_wall_it_never_touches(make_simulation: Make, choice: dict[str, Any]) -> None:
    """72 robots swim at a wall at the boids' 10 % for ten minutes: all come near it, none within 2 cm.

    At full speed a Lily coasts 25 cm while it turns around, and in corners it drifts: there it can touch.
    """
    heading = np.linspace(-1.3, 1.3, 72)
    start = np.stack([0 * heading + 2.6, 0 * heading, 0 * heading - 1.0, heading], axis=-1)[None]
    long_wall = ((-100.0, -100.0, -2.0), (3.0, 100.0, 0.0))
    simulation = make_simulation(start, "heading_hold", (0.0, 0.1, 1.0, 3.0), bounds=long_wall, **choice)
    simulation.world.crew.settings[:, 0] = heading
    nearest = 3.0 - run(simulation, 1200)[..., 0].max(axis=0)
    assert (nearest < 0.25).all()
    assert (nearest > 0.02).all()


def test_contradicting_sensors_do_not_turn_it(make_simulation: Make) -> None:
    """With the same 10 cm on all sides there is no way out: the heading asked for stays as it was."""
    from cocorosim_ros.world.controllers.request import HEADING

    simulation, request = request_at(make_simulation, (0.0, 0.0, -1.0), 0.0, (0.4, 1.0, 1.0, 3.0))
    for distance in (0.0, 0.1, 0.2):
        simulation.sense()
        simulation.readings.obstacle_range[0, 0, :3] = distance
        simulation.decide()
        assert request[HEADING] == 0.4


@pytest.mark.parametrize(("wish", "lowest", "highest"), [(3.0, -1.9, -1.0), (0.0, -1.0, -0.4)])
def test_driven_at_floor_or_surface_it_never_touches(
    make_simulation: Make, wish: float, lowest: float, highest: float
) -> None:
    """Asked to dive below the floor or to surface, the robot stops near the threshold and stays there."""
    simulation = make_simulation([[[0.0, 0.0, -1.0, 0.0]]], "heading_hold", (0.0, 0.0, wish, 3.0), bounds=BOUNDS)
    z = run(simulation, 1200)[:, 0, 2]
    assert lowest < z.min() and z.max() < highest


@pytest.mark.parametrize("place", [(2.9, 0.0, -1.0), (0.0, 0.0, -0.1), (0.0, 0.0, -1.95)])
@pytest.mark.parametrize(("controller", "settings"), [("idle", ()), ("constant", (0.1, -0.2, 0.3))])
def test_direct_commands_are_left_alone(make_simulation: Make, place: Any, controller: str, settings: Any) -> None:
    """Who commands its actuators directly is not disturbed by avoidance, from the first cycle on."""
    simulation = make_simulation([[[*place, 0.0]]], controller, settings, bounds=BOUNDS)
    for _ in range(3):
        simulation.sense()
        simulation.decide()
        assert simulation.command[0, 0].tolist() == list(settings or (0.0, 0.0, 0.0))
