"""Wind above the water and the lift of a hull, by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, YAW_RATE

Make = Callable[..., Any]
AIR, FRONT, SIDE, ARM = 1.225, 0.002, 0.005, 0.02  # kg/m^3, m^2, m^2, m
WIND = {"wind.front": FRONT, "wind.side": SIDE, "wind.arm": ARM}


def forces(acceleration: Make, lily: SimpleNamespace, numbers: Any, state: Any) -> Any:
    """X, Y, N without drag."""
    u, v, r = (state.get(column, 0.0) for column in (SURGE, SWAY, YAW_RATE))
    rates = acceleration(numbers, state)
    return np.array([lily.mass * (rates[0] - v * r), lily.mass * (rates[1] + u * r), lily.inertia * rates[3]])


@pytest.mark.parametrize("yaw", [0.0, 0.7, math.pi])
def test_wind_on_a_vehicle_at_rest(acceleration: Make, lily: SimpleNamespace, yaw: float) -> None:
    """1/2 rho A |W| W along each axis of the body, and the moment of the side about the centre."""
    east, north = 3.0, -4.0
    ahead, aside = east * math.cos(yaw) + north * math.sin(yaw), north * math.cos(yaw) - east * math.sin(yaw)
    found = forces(acceleration, lily, {**WIND, "wind.x": east, "wind.y": north}, {YAW: yaw})
    across = 0.5 * AIR * SIDE * 5.0 * aside
    np.testing.assert_allclose(found, [0.5 * AIR * FRONT * 5.0 * ahead, across, ARM * across], rtol=1e-9)


def test_with_the_wind_there_is_none(acceleration: Make, lily: SimpleNamespace) -> None:
    """At the speed of the air nothing pushes; what still air would resist is given back."""
    found = forces(acceleration, lily, {**WIND, "wind.x": 0.3}, {SURGE: 0.3})
    np.testing.assert_allclose(found, [0.5 * AIR * FRONT * 0.3**2, 0.0, 0.0], atol=1e-15)


def test_wind_does_not_touch_what_moves_up(acceleration: Make, lily: SimpleNamespace) -> None:
    """Without areas there is no force, and none in heave with them."""
    assert forces(acceleration, lily, {"wind.x": 5.0}, {}).tolist() == [0.0, 0.0, 0.0]
    assert acceleration({**WIND, "wind.x": 5.0}, {HEAVE: 0.0})[2] == 0.0


def test_lift_by_hand(acceleration: Make, lily: SimpleNamespace) -> None:
    """Y = -|u| (a v + b r), N = -|u| (c v + d r), the same ahead and astern."""
    numbers = {
        "hull_lift.sway_by_drift": 0.4, "hull_lift.sway_by_turn": 0.03, "hull_lift.yaw_by_drift": 0.002,
        "hull_lift.yaw_by_turn": 0.001,
    }  # fmt: skip
    for u in (0.2, -0.2):
        found = forces(acceleration, lily, numbers, {SURGE: u, SWAY: 0.05, YAW_RATE: -0.3})
        expected = [0.0, -0.2 * (0.4 * 0.05 - 0.03 * 0.3), -0.2 * (0.002 * 0.05 - 0.001 * 0.3)]
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-15)


def test_lift_of_a_hull_that_climbs_by_hand(acceleration: Make, lily: SimpleNamespace) -> None:
    """Z = -e |u| w, the same ahead and astern, and nothing else: what is left is the lift's, by the mass."""
    for u in (0.2, -0.2):
        speed = {SURGE: u, HEAVE: 0.05}
        more, less = (acceleration({"hull_lift.heave_by_climb": e}, speed)[2] for e in (0.4, 0.0))
        assert lily.mass * (more - less) == pytest.approx(-0.4 * 0.2 * 0.05, rel=1e-9)


def test_lift_across_takes_energy(acceleration: Make, lily: SimpleNamespace) -> None:
    """With a and d alone the power is -|u| (a v^2 + d r^2)."""
    numbers = {"hull_lift.sway_by_drift": 0.4, "hull_lift.yaw_by_turn": 0.001}
    speed = np.array([0.2, -0.05, 0.4])
    found = forces(acceleration, lily, numbers, dict(zip((SURGE, SWAY, YAW_RATE), speed, strict=True)))
    assert float(found @ speed) == pytest.approx(-0.2 * (0.4 * 0.05**2 + 0.001 * 0.4**2), rel=1e-9)
