"""The operating system's depth and dive-speed controllers."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.sensors import SENSORS

Make = Callable[..., Any]


def heaves(simulation: Any, ticks: int) -> Any:
    """Heave (ticks,) of the only robot after each tick."""
    found = []
    for _ in range(ticks):
        simulation.sense()
        simulation.decide()
        simulation.advance()
        found.append(simulation.state[0, 0, 6])
    return np.array(found)


def steady_climb(wanted: float, lily: SimpleNamespace) -> float:
    """Speed w at which the pump's 1300 (wanted - w) / 127.5 of its force is the drag k w^2, wanted > 0."""
    gain = 1300.0 / 127.5 * lily.pump
    return (-gain + math.sqrt(gain * gain + 4.0 * lily.drag * gain * wanted)) / (2.0 * lily.drag)


@pytest.mark.parametrize("choice", [{}, {"integrator": "semi_implicit_euler", "steps": 1}])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_dive_speed_settles_in_2_s_at_0_0193(
    make_simulation: Make, lily: SimpleNamespace, sign: float, choice: dict[str, Any]
) -> None:
    """A resting boid asked for 0.02 m/s climbs with 0.0193 m/s from 2 s on, within 5 %; so downwards."""
    from cocorosim_ros.world.controllers.request import DIVE

    resting = (*lily.boids[:9], 0.0, *lily.boids[10:])
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]], "boids_blt", resting, **choice)
    simulation.memory[0, 0, DIVE] = sign * 0.02
    found = heaves(simulation, 40)
    steady = steady_climb(0.02, lily)
    assert steady == pytest.approx(0.0193, abs=5e-5)
    assert found[-1] == pytest.approx(sign * steady, rel=1e-4)
    np.testing.assert_allclose(found[3:], sign * steady, rtol=0.05)


@pytest.mark.parametrize(("depth", "sign"), [(8.0, -1.0), (2.0, 1.0)])
def test_depth_is_sought_with_5_cm_s_at_most(
    make_simulation: Make, lily: SimpleNamespace, depth: float, sign: float
) -> None:
    """Three metres away, the robot is asked for 0.05 m/s towards its depth, and not more."""
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]], "heading_hold", (0.0, 0.0, depth, 3.0))
    found = heaves(simulation, 30)
    assert found[-1] == pytest.approx(sign * steady_climb(0.05, lily), rel=1e-4)


def test_near_its_depth_the_speed_asked_for_is_the_distance(make_simulation: Make) -> None:
    """2 cm above its depth and at rest: the pump starts with 1300 * -0.02 = -26 of 127.5."""
    simulation = make_simulation([[[0.0, 0.0, -4.98, 0.0]]], "heading_hold", (0.0, 0.0, 5.0, 3.0))
    simulation.sense()
    simulation.decide()
    assert simulation.command[0, 0, 2] * 127.5 == pytest.approx(-26.0, abs=1e-6)


def test_acceleration_is_fed_forward(make_simulation: Make, lily: SimpleNamespace) -> None:
    """At its depth, at rest, while the pump lifts with 0.01 N: 130 * 0.01 / 0.44 counts upwards."""
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]], "heading_hold", (0.0, 0.0, 5.0, 3.0))
    simulation.state[0, 0, 10] = 0.01
    simulation.sense()
    simulation.decide()
    assert simulation.command[0, 0, 2] * 127.5 == pytest.approx(130.0 * 0.01 / lily.mass, abs=1e-6)


@pytest.mark.parametrize(("measured", "band"), [(True, 1e-3), (False, 0.05)])
def test_depth_is_reached_and_held(make_simulation: Make, measured: bool, band: float) -> None:
    """From 5 m to 5.4 m in 60 s: to a millimetre by its own velocity, to 5 cm by the change of pressure.

    Half a tick late, the change of pressure leaves the loop nearly undamped: the robot bobs by some 3 cm.
    """
    simulation = make_simulation([[[0.0, 0.0, -5.0, 0.0]]], "heading_hold", (0.0, 0.1, 5.4, 3.0))
    simulation.world.instruments.measured[:, list(SENSORS).index("velocity")] = measured
    heaves(simulation, 120)
    for _ in range(20):
        heaves(simulation, 5)
        assert simulation.state[0, 0, 2] == pytest.approx(-5.4, abs=band)
