"""The operating system's heading controller: its step response and what it does at the thrusters' limit."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

START = [[[0.0, 0.0, -5.0, 0.0]]]
Make = Callable[..., Any]


def first_command(simulation: Any) -> Any:
    """Command (3,) of the first cycle."""
    simulation.sense()
    simulation.decide()
    return simulation.command[0, 0]


@pytest.mark.parametrize(("gain", "seconds", "overshoot"), [(3.0, 14.5, 0.06), (15.0, 6.5, 0.05)])
def test_quarter_turn(make_simulation: Make, gain: float, seconds: float, overshoot: float) -> None:
    """With the paper's inertia and scheme 90 % of a right angle take 14.5 s (gain 3) or 6.5 s (gain 15).

    The first tick at or beyond 90 % counts, yaw drag included; without it, it would be 13.5 s and 6.0 s.
    """
    choice = {"integrator": "semi_implicit_euler", "steps": 1, "inertia": 5e-4}
    simulation = make_simulation(START, "heading_hold", (0.5 * math.pi, 0.1, 5.0, gain), **choice)
    share = [0.0]
    for _ in range(120):
        first_command(simulation)
        simulation.advance()
        share.append(simulation.state[0, 0, 3] / (0.5 * math.pi))
    assert 0.5 * np.argmax(np.array(share) >= 0.9) == seconds
    assert max(share) - 1.0 == pytest.approx(overshoot, abs=0.003)
    assert share[-1] == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("heading", "speed", "gain", "left", "right"),
    [
        # turn = 5 gain error, left and right = 127 speed -+ turn / 2, of 127.5; no saturation
        (0.0, 0.1, 3.0, 12.7, 12.7),
        (0.4, 0.1, 3.0, 12.7 - 3.0, 12.7 + 3.0),
        (-0.4, 0.1, 3.0, 12.7 + 3.0, 12.7 - 3.0),
        # 130 asked of the right: 3 less on the left
        (0.4, 1.0, 3.0, 127.0 - 3.0 - 3.0, 127.0),
        (-0.4, 1.0, 3.0, 127.0, 127.0 - 3.0 - 3.0),
        # 63.5 +- 112.5 ask 176 of the right: 49 less on the left
        (3.0, 0.5, 15.0, 63.5 - 112.5 - 49.0, 127.0),
        (-3.0, 0.5, 15.0, 127.0, 63.5 - 112.5 - 49.0),
        # -+ 150: both at their limit
        (3.0, 0.0, 20.0, -127.0, 127.0),
    ],
)
def test_thrusters(make_simulation: Make, heading: float, speed: float, gain: float, left: float, right: float) -> None:
    """At rest, heading 0: the thrusters share the turn, and what one cannot give is taken from the other."""
    command = first_command(make_simulation(START, "heading_hold", (heading, speed, 5.0, gain)))
    np.testing.assert_allclose(command[:2] * 127.5, [left, right], rtol=0, atol=1e-9)


def test_yaw_rate_damps(make_simulation: Make) -> None:
    """Turning left at 0.1 rad/s through the heading at gain 4: 12 counts against it, 6 per thruster."""
    simulation = make_simulation(START, "heading_hold", (0.0, 0.1, 5.0, 4.0))
    simulation.state[0, 0, 7] = 0.1
    np.testing.assert_allclose(first_command(simulation)[:2] * 127.5, [18.7, 6.7], rtol=0, atol=1e-9)


@pytest.mark.parametrize(("heading", "yaw", "turns_left"), [(3.0, -3.0, False), (-3.0, 3.0, True), (1.0, 8.0, False)])
def test_the_shorter_way_round(make_simulation: Make, heading: float, yaw: float, turns_left: bool) -> None:
    """Across west, and after whole turns, the robot turns the shorter way."""
    command = first_command(make_simulation([[[0.0, 0.0, -5.0, yaw]]], "heading_hold", (heading, 0.0, 5.0, 3.0)))
    assert (command[1] > command[0]) == turns_left


def test_full_speed_is_127_of_127_5(make_simulation: Make) -> None:
    """The operating system's full command delivers 0.99608 of the maximum, and more than full is full."""
    for speed in (1.0, 3.0):
        command = first_command(make_simulation(START, "heading_hold", (0.0, speed, 5.0, 3.0)))
        np.testing.assert_allclose(command[:2], 0.99608, rtol=0, atol=1e-5)
