"""Surge and heave against the ln-cosh law of quadratic drag: m v' = F - k v^2."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

# Largest error of 20 s from rest at full thrust with steps of 0.1 s. rk4: the fifth-order term of one step
# (about 1e-10 m) added up; semi-implicit Euler: half a step at terminal speed, 0.05 s * 0.075 m/s = 3.75 mm,
# and as much again from the force being that of the step's beginning.
POSITION_TOLERANCE = {"rk4": 1e-8, "semi_implicit_euler": 7.5e-3}  # m
SPEED_TOLERANCE = {"rk4": 1e-8, "semi_implicit_euler": 7.5e-4}  # m/s

START = [[[0.0, 0.0, -500.0, 0.0]]]
Make = Callable[..., Any]


def swim(simulation: Any, fractions: Any, ticks: int) -> Any:
    """States (ticks + 1, 8) of the only robot under constant commands."""
    states = [simulation.state[0, 0, :8].copy()]
    for _ in range(ticks):
        simulation.command[0, 0] = fractions
        simulation.advance()
        states.append(simulation.state[0, 0, :8].copy())
    return np.array(states)


@pytest.mark.parametrize("integrator", POSITION_TOLERANCE)
def test_surge_from_rest_follows_ln_cosh(make_simulation: Make, lily: SimpleNamespace, integrator: str) -> None:
    """x(t) = m/k ln cosh(sqrt(F k) t / m) and v(t) = sqrt(F/k) tanh(sqrt(F k) t / m)."""
    states = swim(make_simulation(START, integrator=integrator), (1.0, 1.0, 0.0), 40)
    time, force = 0.5 * np.arange(41), 2 * lily.thrust
    rate = math.sqrt(force * lily.drag) / lily.mass
    x = lily.mass / lily.drag * np.log(np.cosh(rate * time))
    v = math.sqrt(force / lily.drag) * np.tanh(rate * time)
    np.testing.assert_allclose(states[:, 0], x, rtol=0, atol=POSITION_TOLERANCE[integrator])
    np.testing.assert_allclose(states[:, 4], v, rtol=0, atol=SPEED_TOLERANCE[integrator])
    assert not states[:, [1, 3, 5, 6, 7]].any()


@pytest.mark.parametrize("integrator", POSITION_TOLERANCE)
@pytest.mark.parametrize(("fraction", "speed"), [(1.0, 0.0750), (0.5, 0.05303), (0.1, 0.02372), (0.08, 0.02121)])
def test_terminal_speed(make_simulation: Make, integrator: str, fraction: float, speed: float) -> None:
    """Full, half, 10 % and 8 % thrust end at 7.5, 5.303, 2.372 and 2.121 cm/s with every integrator."""
    states = swim(make_simulation(START, integrator=integrator), (fraction, fraction, 0.0), 300)
    assert states[-1, 4] == pytest.approx(speed, abs=1e-5)


def test_ten_centimetres_take_3_170_seconds(make_simulation: Make) -> None:
    """The continuous law passes 10 cm at 3.170 s, and stands at 9.23 cm at the paper's 3.03 s."""
    from scipy.interpolate import CubicHermiteSpline

    states = swim(make_simulation(START), (1.0, 1.0, 0.0), 8)
    track = CubicHermiteSpline(0.5 * np.arange(9), states[:, 0], states[:, 4])
    assert track.solve(0.10, extrapolate=False)[-1] == pytest.approx(3.170, abs=1e-3)
    assert track(3.03) == pytest.approx(0.0923, abs=5e-5)


def test_the_papers_scheme_swims_10_73_cm_in_3_s(make_simulation: Make) -> None:
    """Semi-implicit Euler at 0.5 s is at 10.73 cm after 3 s and passes 10 cm at 2.870 s, interpolated."""
    states = swim(make_simulation(START, integrator="semi_implicit_euler", steps=1), (1.0, 1.0, 0.0), 6)
    assert states[6, 0] == pytest.approx(0.1073, abs=5e-5)
    assert np.interp(0.10, states[:, 0], 0.5 * np.arange(7)) == pytest.approx(2.870, abs=1e-3)


def test_coasting_follows_the_hyperbola(make_simulation: Make, lily: SimpleNamespace) -> None:
    """With thrusters off v(t) = 1/(1/v0 + k t/m) and x(t) = m/k ln(1 + k v0 t/m)."""
    simulation = make_simulation(START)
    simulation.state[0, 0, 4] = v0 = 0.075
    states, time = swim(simulation, (0.0, 0.0, 0.0), 60), 0.5 * np.arange(61)
    slowing = 1.0 + lily.drag * v0 * time / lily.mass
    np.testing.assert_allclose(states[:, 4], v0 / slowing, rtol=0, atol=1e-8)
    np.testing.assert_allclose(states[:, 0], lily.mass / lily.drag * np.log(slowing), rtol=0, atol=1e-8)


def test_full_pump_lifts_with_0_0981_n_to_0_235_m_s(make_simulation: Make, lily: SimpleNamespace) -> None:
    """10 cm^3 more of water weigh 0.0981 N; the climb is ln-cosh with that force and ends at 0.2349 m/s."""
    simulation = make_simulation(START)
    states = swim(simulation, (0.0, 0.0, 1.0), 40)
    assert simulation.state[0, 0, 10] == pytest.approx(0.0981, abs=1e-12)
    assert states[-1, 6] == pytest.approx(0.2349, abs=5e-5)
    rate = math.sqrt(0.0981 * lily.drag) / lily.mass
    z = -500.0 + lily.mass / lily.drag * np.log(np.cosh(rate * 0.5 * np.arange(41)))
    np.testing.assert_allclose(states[:, 2], z, rtol=0, atol=1e-6)


def test_the_pump_sinks_as_it_lifts(make_simulation: Make) -> None:
    """Half the pump downwards is the mirror image of half the pump upwards."""
    up = swim(make_simulation(START), (0.0, 0.0, 0.5), 10)
    down = swim(make_simulation(START), (0.0, 0.0, -0.5), 10)
    np.testing.assert_allclose(down[:, 2] + 500.0, -(up[:, 2] + 500.0), rtol=0, atol=1e-10)
    assert up[-1, 2] > -499.5


def test_drag_acts_on_the_total_speed(make_simulation: Make, lily: SimpleNamespace) -> None:
    """Coasting obliquely, surge and heave lose the same fraction: the direction of motion stays."""
    simulation = make_simulation(START)
    simulation.state[0, 0, 4:7] = (0.03, 0.02, 0.06)
    states = swim(simulation, (0.0, 0.0, 0.0), 20)
    speed = 0.07 / (1.0 + lily.drag * 0.07 * 10.0 / lily.mass)
    np.testing.assert_allclose(states[-1, 4:7], np.array([0.03, 0.02, 0.06]) * speed / 0.07, rtol=0, atol=1e-8)
