"""The order of each integrator on a curved manoeuvre, against an independent referee."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

ORDER = {"rk4": 4.0, "semi_implicit_euler": 1.0}
# (m, rad) after 100 s of commands drawn anew every 0.5 s from the full range, steps of 0.25 s. Reversals of
# the flow, where v |v| has a kink, dominate for rk4.
TOLERANCE = {"rk4": (1e-3, 1e-3), "semi_implicit_euler": (0.2, 0.5)}
MOVING = np.array([0.0, 0.0, -500.0, 0.3, 0.03, 0.01, 0.02, 0.2])
CURVED = (0.2, 0.9, 0.3)  # surge, sway, heave and yaw together; no velocity passes through zero
Make = Callable[..., Any]


def end_of(simulation: Any, row: Any, commands: Any) -> Any:
    """State (8,) of the only robot after one tick for each of `commands`."""
    simulation.state[0, 0, :8] = row
    for fractions in commands:
        simulation.command[0, 0] = fractions
        simulation.advance()
    return simulation.state[0, 0, :8].copy()


@pytest.mark.parametrize("integrator", ORDER)
def test_order(make_simulation: Make, newton: Make, integrator: str) -> None:
    """Halving the step divides the error of a curved manoeuvre by 16 (rk4) or 2 (semi-implicit Euler)."""
    truth, errors = newton(MOVING, CURVED, 4.0), []
    for steps in (2, 4, 8):
        simulation = make_simulation([[MOVING[:4]]], integrator=integrator, steps=steps)
        errors.append(np.linalg.norm(end_of(simulation, MOVING, [CURVED] * 8) - truth))
    orders = [math.log2(errors[0] / errors[1]), math.log2(errors[1] / errors[2])]
    assert orders == pytest.approx([ORDER[integrator]] * 2, abs=0.3)


def test_a_fine_step_meets_the_referee(make_simulation: Make, newton: Make) -> None:
    """All eight numbers of the state agree with Newton's law in world axes to 1e-9 at steps of 0.025 s."""
    simulation = make_simulation([[MOVING[:4]]], steps=20)
    state = end_of(simulation, MOVING, [CURVED] * 8)
    np.testing.assert_allclose(state, newton(MOVING, CURVED, 4.0), rtol=0, atol=1e-9)


@pytest.mark.parametrize("integrator", ORDER)
def test_long_run_of_wild_commands(make_simulation: Make, newton: Make, integrator: str) -> None:
    """After 100 s of random full-range commands the pose is still within the tolerance of its integrator."""
    commands = np.random.default_rng(0).uniform(-1.0, 1.0, (200, 3))
    truth = np.array([0.0, 0.0, -500.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    simulation = make_simulation([[truth[:4]]], integrator=integrator, steps=2)
    state = end_of(simulation, truth, commands)
    for fractions in commands:
        truth = newton(truth, fractions, 0.5)
    metres, radians = TOLERANCE[integrator]
    assert np.linalg.norm(state[:3] - truth[:3]) < metres
    assert abs(state[3] - truth[3]) < radians
