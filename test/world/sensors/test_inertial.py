"""The IMU: gravity at rest, and the specific force of motion found by differentiating positions."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

START = [[[0.0, 0.0, -500.0, 0.7]]]
Make = Callable[..., Any]


def reading_after(simulation: Any, commands: Any) -> Any:
    """Specific force (3,) and angular rate (3,) of the only robot after one tick per row of `commands`."""
    for fractions in commands:
        simulation.command[0, 0] = fractions
        simulation.advance()
    readings = simulation.sense()
    return readings.specific_force[0, 0], readings.angular_rate[0, 0]


def test_at_rest_it_reads_gravity_upwards(make_simulation: Make) -> None:
    """Resting, the specific force is +9.81 m/s^2 along z and nothing turns."""
    force, rate = reading_after(make_simulation(START), [])
    assert force.tolist() == [0.0, 0.0, 9.81]
    assert rate.tolist() == [0.0, 0.0, 0.0]


def test_standing_start(make_simulation: Make, lily: SimpleNamespace) -> None:
    """Under full thrust and pump at zero speed: (F/m, 0, 9.81 + B/m)."""
    simulation = make_simulation(START)
    simulation.state[0, 0, 8:11] = (lily.thrust, lily.thrust, lily.pump)
    force, _ = reading_after(simulation, [])
    np.testing.assert_allclose(force, [0.01 / 0.44, 0.0, 9.81 + 0.0981 / 0.44], rtol=1e-12)


def test_steady_turn_is_centripetal(make_simulation: Make) -> None:
    """In a steady circle the horizontal force is speed times yaw rate, across the velocity, inwards."""
    simulation = make_simulation(START)
    force, rate = reading_after(simulation, [(0.5, 0.6, 0.0)] * 600)
    velocity = simulation.state[0, 0, 4:6]
    assert rate[2] == pytest.approx(math.sqrt(0.1 * 0.0249695 * 0.005 / 1.14e-4), rel=1e-4)
    np.testing.assert_allclose(force[:2], rate[2] * np.array([-velocity[1], velocity[0]]), rtol=1e-6)
    assert force[1] > 0.0


@pytest.mark.parametrize("fractions", [(0.2, 0.9, 0.3), (1.0, -0.5, -0.8)])
def test_specific_force_is_the_second_difference_of_positions(make_simulation: Make, fractions: Any) -> None:
    """In the middle of a manoeuvre, turned into the body and with gravity added, positions tell the same."""
    simulation = make_simulation(START, steps=50)
    reading_after(simulation, [fractions] * 4)
    step = simulation.world.stepping.step
    from cocorosim_ros.world.motion.motion import move

    short = simulation.world.stepping._replace(steps=1)
    rows = [simulation.state[0, 0].copy()]
    for _ in range(2):
        world = simulation.world
        move(simulation.state, world.vehicles, world.tank, short, np.zeros(0), 0.0)
        rows.append(simulation.state[0, 0].copy())
        if len(rows) == 2:
            force = simulation.sense().specific_force[0, 0].copy()
    acceleration = (rows[2][:3] - 2.0 * rows[1][:3] + rows[0][:3]) / step**2
    cosine, sine = math.cos(rows[1][3]), math.sin(rows[1][3])
    forward = acceleration[0] * cosine + acceleration[1] * sine
    left = acceleration[1] * cosine - acceleration[0] * sine
    np.testing.assert_allclose(force, [forward, left, acceleration[2] + 9.81], rtol=0, atol=2e-5)


def test_the_gyro_shows_the_change_of_heading(make_simulation: Make) -> None:
    """Over 0.5 s of a steady turn the heading changes by the yaw rate times 0.5 s."""
    simulation = make_simulation(START)
    _, rate = reading_after(simulation, [(-1.0, 1.0, 0.0)] * 100)
    before = simulation.state[0, 0, 3]
    simulation.advance()
    assert simulation.state[0, 0, 3] - before == pytest.approx(0.5 * rate[2], rel=1e-6)
