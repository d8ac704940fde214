"""Energy: drag only takes, still water never gives, and what thrusters give is what is found."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

Make = Callable[..., Any]


def energy(states: Any, lily: SimpleNamespace) -> Any:
    """Kinetic energy [J] of every row."""
    return 0.5 * lily.mass * (states[..., 4:7] ** 2).sum(-1) + 0.5 * lily.inertia * states[..., 7] ** 2


@pytest.mark.parametrize("integrator", ["rk4", "semi_implicit_euler"])
def test_drag_never_adds_energy(make_simulation: Make, lily: SimpleNamespace, integrator: str) -> None:
    """300 robots with random velocities and engines off lose energy in every tick."""
    draw = np.random.default_rng(3)
    start = np.zeros((1, 300, 4))
    start[..., 2] = -500.0
    simulation = make_simulation(start, integrator=integrator)
    simulation.state[..., 4:8] = draw.uniform(-1.0, 1.0, (1, 300, 4)) * [0.1, 0.1, 0.3, 1.5]
    before = energy(simulation.state, lily)
    for _ in range(40):
        simulation.advance()
        after = energy(simulation.state, lily)
        assert (after < before).all()
        before = after


def test_still_water_never_drives(make_simulation: Make, crowd: Make) -> None:
    """Who rests with engines off stays where it is, to the last bit."""
    simulation = make_simulation(crowd(2, 11))
    before = simulation.state.copy()
    for _ in range(50):
        simulation.sense()
        simulation.decide()
        simulation.advance()
    assert np.array_equal(simulation.state, before)


def test_work_of_thrust_less_work_of_drag_is_the_energy_gained(make_simulation: Make, lily: SimpleNamespace) -> None:
    """Along a curve, F.v + T r - k |v|^3 - Cr |r|^3 integrated over time is the kinetic energy gained."""
    simulation = make_simulation([[[0.0, 0.0, -500.0, 0.0]]], steps=50)
    left, right, pump = 0.3, 0.8, 0.4
    states = [simulation.state[0, 0].copy()]
    for _ in range(20):
        simulation.command[0, 0] = (left, right, pump)
        simulation.advance()
        states.append(simulation.state[0, 0].copy())
    s = np.array(states)
    power = (left + right) * lily.thrust * s[:, 4] + pump * lily.pump * s[:, 6]
    power += (right - left) * lily.thrust * lily.lever * s[:, 7]
    power -= lily.drag * np.linalg.norm(s[:, 4:7], axis=1) ** 3 + lily.yaw_drag * np.abs(s[:, 7]) ** 3
    from scipy.integrate import simpson

    assert simpson(power, dx=0.5) == pytest.approx(energy(s[-1], lily), rel=5e-3)
