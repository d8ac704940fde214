"""Bodies in moving water, against closed forms and scipy."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.tick.water import Water
from cocorosim_ros.world.water.flow import make_flow

Make = Callable[..., Any]


def in_flow(make_simulation: Make, start: Any, currents: list[tuple[str, list[float]]], **choice: Any) -> Simulation:
    """A simulation like those of make_simulation, in water with currents."""
    still = make_simulation(start, **choice)
    flow = make_flow([(name, np.array(numbers)) for name, numbers in currents])
    return Simulation(replace(still.world, water=Water(flow=flow)), np.asarray(start, dtype=float))


def ticks(simulation: Simulation, number: int) -> None:
    """Let time pass with all actuators off."""
    for _ in range(number):
        simulation.advance()


def test_a_drifting_body_reaches_the_speed_of_the_water(make_simulation: Make, lily: SimpleNamespace) -> None:
    """From rest in a current V the speed through the water is V / (1 + k V t / m), whatever the heading."""
    speed, yaw = math.hypot(0.06, -0.08), 0.7
    simulation = in_flow(make_simulation, [[[0, 0, -1, yaw]]], [("uniform", [0.06, -0.08])], steps=20)
    for tick in range(1, 121):
        simulation.advance()
        through = speed / (1.0 + lily.drag * speed * 0.5 * tick / lily.mass)
        measured = simulation.sense().velocity[0, 0]
        assert math.hypot(measured[0], measured[1]) == pytest.approx(through, rel=1e-9)
    time_constant = lily.mass / (lily.drag * speed)
    run_through = speed * time_constant * math.log1p(60.0 / time_constant)
    drifted = (speed * 60.0 - run_through) * np.array([0.6, -0.8])
    np.testing.assert_allclose(simulation.state[0, 0, :2], drifted, rtol=1e-8)


@pytest.mark.parametrize("integrator", ["rk4", "semi_implicit_euler"])
def test_a_uniform_current_is_a_moving_frame(make_simulation: Make, integrator: str) -> None:
    """A robot that starts with the water swims as in still water, seen from the water: Galileo."""
    thrust = [0.8, 0.3, 0.4]
    choice = {"integrator": integrator, "steps": 5, "inertia": 5e-4}
    still = make_simulation([[[0, 0, -50, 0.3]]], **choice)
    moving = in_flow(make_simulation, [[[0, 0, -50, 0.3]]], [("uniform", [0.05, -0.02])], **choice)
    moving.state[0, 0, 4] = 0.05 * math.cos(0.3) - 0.02 * math.sin(0.3)
    moving.state[0, 0, 5] = -0.02 * math.cos(0.3) - 0.05 * math.sin(0.3)
    for simulation in (still, moving):
        simulation.command[0, 0] = thrust
        ticks(simulation, 40)
    carried = still.state[0, 0, :3] + 20.0 * np.array([0.05, -0.02, 0.0])
    # rk4 takes body axes, in which a steady velocity turns: it is off by its own error.
    np.testing.assert_allclose(moving.state[0, 0, :3], carried, rtol=0, atol=1e-6 if integrator == "rk4" else 1e-12)
    np.testing.assert_allclose(moving.sense().velocity, still.sense().velocity, rtol=0, atol=2e-6)
    np.testing.assert_allclose(moving.readings.specific_force, still.readings.specific_force, rtol=0, atol=2e-5)
    assert moving.readings.pressure == pytest.approx(still.readings.pressure)


def test_an_eddy_carries_a_body_as_scipy_says(make_simulation: Make, lily: SimpleNamespace) -> None:
    """The path of a passive body around an eddy in a tide is that of an independent integration in world axes."""
    numbers = {"vortex": [0.3, -0.2, 0.12, 0.4], "tidal": [0.01, 0.02, 37.0, 0.4]}
    simulation = in_flow(make_simulation, [[[0.9, 0.1, -1.0, 2.0]]], list(numbers.items()), steps=10)

    def rate(time: float, y: Any) -> Any:
        east, north = y[0] - 0.3, y[1] + 0.2
        squared = east**2 + north**2
        turn = 0.12 / (2 * math.pi * squared) * (1 - math.exp(-squared / 0.16))
        swing = math.sin(2 * math.pi * time / 37.0 + 0.4)
        through = y[2:] - np.array([-turn * north + 0.01 * swing, turn * east + 0.02 * swing])
        return np.concatenate([y[2:], -lily.drag / lily.mass * np.hypot(*through) * through])

    reference = solve_ivp(rate, (0.0, 100.0), [0.9, 0.1, 0.0, 0.0], rtol=1e-11, atol=1e-13)
    ticks(simulation, 200)
    np.testing.assert_allclose(simulation.state[0, 0, :2], reference.y[:2, -1], rtol=0, atol=1e-6)


def test_a_robot_that_holds_its_place_sees_water_pass(make_simulation: Make) -> None:
    """At rest over ground in a current (0.1, 0.2), heading north: through the water 0.2 m/s back, 0.1 m/s left."""
    simulation = in_flow(make_simulation, [[[0, 0, -1, math.pi / 2]]], [("uniform", [0.1, 0.2])])
    np.testing.assert_allclose(simulation.sense().velocity[0, 0], [-0.2, 0.1, 0.0, 0.0], rtol=0, atol=1e-16)
    assert simulation.readings.pressure[0, 0] == 101325.0 + 9810.0


def test_accelerometer_feels_the_current(make_simulation: Make, lily: SimpleNamespace) -> None:
    """At rest in a current V ahead the hull is dragged along with k V^2 / m; gravity stays."""
    simulation = in_flow(make_simulation, [[[0, 0, -1, 0]]], [("uniform", [0.1, 0.0])])
    expected = [lily.drag * 0.01 / lily.mass, 0.0, 9.81]
    np.testing.assert_allclose(simulation.sense().specific_force[0, 0], expected, rtol=1e-14, atol=1e-16)
