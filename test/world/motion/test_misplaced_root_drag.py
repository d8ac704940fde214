"""The drag of the released model whose root closes too early, against its formula worked out by hand in world axes."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, X, Y, Z

Make = Callable[..., Any]


def force_by_hand(drag: float, x: float, y: float, z: float) -> Any:
    """X, Y, Z [N; world] on a body that moves at x, y, z [m/s; world]: k U^2, split by the angle of the wrong root."""
    whole, level = drag * (x * x + y * y + z * z), math.hypot(x, y)
    angle = math.atan2(abs(z), abs(x) + y * y)
    flat = whole * math.cos(angle) / level if level else 0.0
    return np.array([-flat * x, -flat * y, -math.copysign(whole * math.sin(angle), z)])


@pytest.mark.parametrize("yaw", [0.0, 0.7, 0.5 * math.pi, -2.0])
@pytest.mark.parametrize("velocity", [(0.03, 0.0, 0.01), (0.02, -0.01, 0.02), (0.0, 0.02, -0.03), (0.0, 0.0, 0.02)])
def test_force_by_the_formula(acceleration: Make, lily: SimpleNamespace, yaw: float, velocity: Any) -> None:
    """In any heading the force is that of the formula, in the axes of the world."""
    u, v, w = velocity
    x, y = u * math.cos(yaw) - v * math.sin(yaw), u * math.sin(yaw) + v * math.cos(yaw)
    numbers = {"drag": lily.drag, "misplaced_root_drag.share": 1.0}
    rates = acceleration(numbers, {SURGE: u, SWAY: v, HEAVE: w, YAW: yaw}) * lily.mass
    world = force_by_hand(lily.drag, x, y, w)
    body = [
        world[0] * math.cos(yaw) + world[1] * math.sin(yaw),
        world[1] * math.cos(yaw) - world[0] * math.sin(yaw),
        world[2],
    ]
    assert rates[:3] == pytest.approx(body, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize(("yaw", "rise"), [(0.5 * math.pi, 0.0), (0.0, 0.02)])
def test_nothing_is_wrong_at_constant_depth_and_along_x(
    acceleration: Make, lily: SimpleNamespace, yaw: float, rise: float
) -> None:
    """Along y without a rise, and along x with one, the drag is k U against the motion."""
    numbers = {"drag": lily.drag, "misplaced_root_drag.share": 1.0}
    rates = acceleration(numbers, {SURGE: 0.03, HEAVE: rise, YAW: yaw}) * lily.mass
    speed = math.hypot(0.03, rise)
    assert rates[:3] == pytest.approx([-lily.drag * speed * 0.03, 0.0, -lily.drag * speed * rise], abs=1e-12)


def test_along_y_a_robot_that_rises_is_too_fast(swim: Make, lily: SimpleNamespace) -> None:
    """Pushed along y and up for 100 s it moves as Euler steps of the formula have it, twice as fast as along x.

    Tolerance: RK4 with steps of 10 ms against Euler's of 1 ms, whose error is of the first order.
    """
    fraction, pump = 0.1, 0.02
    numbers = {"drag": lily.drag, "misplaced_root_drag.share": 1.0}
    commands = [(fraction, fraction, pump)] * 200
    speeds = []
    for yaw in (0.5 * math.pi, 0.0):
        path = swim(numbers, {YAW: yaw}, commands, tick=0.5, steps=50, bounds=((-50, -50, -50), (50, 50, 50)))
        push = np.array([2 * lily.thrust * fraction * math.cos(yaw), 2 * lily.thrust * fraction * math.sin(yaw)])
        thrust = np.array([*push, lily.pump * pump])
        velocity, place = np.zeros(3), np.array([path[0, 0, X], path[0, 0, Y], path[0, 0, Z]])
        for _ in range(100_000):
            velocity += 0.001 / lily.mass * (thrust + force_by_hand(lily.drag, *velocity))
            place = place + 0.001 * velocity
        assert path[-1, 0, [X, Y, Z]] == pytest.approx(place, abs=1e-3)
        speeds.append(math.hypot(velocity[0], velocity[1]))
    assert speeds[0] > 2.0 * speeds[1]
