"""Water that grows denser, hulls that leave the water, thrust lost near the surface and thrust to the side, by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.effects.hull_emergence import hull_emergence
from cocorosim_ros.world.effects.side_thrust_lever import side_thrust_lever
from cocorosim_ros.world.effects.surface_loss import surface_loss
from cocorosim_ros.world.state.state import HEAVE, Z

Make = Callable[..., Any]
THRUST = np.array([0.01, -0.004, 0.002, 3e-4])  # N, N, N, N m


def added(effect: Any, z: float, *numbers: float) -> Any:
    """The wrench that an effect adds to nothing, at a height."""
    row, total = np.zeros(26), np.zeros(4)
    row[Z] = z
    effect(row, np.zeros(4), moment(), np.array(numbers), total)
    return total


def moment() -> Any:
    """A moment at which the thrusters give THRUST."""
    from cocorosim_ros.world.terms.moment import Moment

    return Moment(
        0.0, THRUST, np.zeros(3), np.zeros((3, 4)), np.zeros(3, dtype=bool), 0.0, 0.0, 1.0, 1.0, 0.5,
        np.zeros((0, 5)), -1, 0.0, np.zeros((0, 8)),
    )  # fmt: skip


@pytest.mark.parametrize(("depth", "force"), [(0.0, 0.0), (0.5, 1e-3), (2.0, 4e-3)])
def test_denser_water_carries_more(acceleration: Make, lily: SimpleNamespace, depth: float, force: float) -> None:
    """Two millinewtons per metre of depth, and nothing at the surface."""
    found = acceleration({"density_gradient.gradient": 2e-3}, {Z: -depth})
    assert lily.mass * found[2] == pytest.approx(force, abs=1e-12)


def test_between_ballast_and_denser_water_it_swings(swim: Make, lily: SimpleNamespace) -> None:
    """Trimmed for 1 m, without drag: a sine about that depth with the rate sqrt(gradient / mass), see Turner."""
    gradient = 2e-3
    rate = math.sqrt(gradient / lily.mass)
    numbers = {"density_gradient.gradient": gradient, "buoyancy_trim.force": -gradient}
    path = swim(numbers, {Z: -1.0, HEAVE: 0.01}, [(0.0, 0.0, 0.0)] * 120)[:, 0]
    time = 0.5 * np.arange(len(path))
    np.testing.assert_allclose(path[:, Z], -1.0 + 0.01 / rate * np.sin(rate * time), atol=1e-6)


@pytest.mark.parametrize(("z", "out"), [(-0.2, 0.0), (-0.05, 0.0), (-0.025, 0.25), (0.0, 0.5), (0.05, 1.0), (0.3, 1.0)])
def test_what_is_out_of_the_water_carries_nothing(z: float, out: float) -> None:
    """A hull of 0.1 m: a quarter of it is out where its middle is 25 mm deep; 0.8 of the weight of 4 N at most."""
    np.testing.assert_allclose(added(hull_emergence, z, 0.8, 0.1, 4.0), [0.0, 0.0, -3.2 * out, 0.0], atol=1e-12)


def test_a_buoyant_hull_floats_where_both_forces_meet(swim: Make) -> None:
    """Pushed up with 0.1 N, with 0.8 N of buoyancy to lose over 0.1 m: 1/8 of the hull is out, z = -37.5 mm."""
    numbers = {
        "hull_emergence.share": 0.8, "hull_emergence.height": 0.1, "hull_emergence.weight": 1.0,
        "buoyancy_trim.force": 0.1, "linear_drag.heave": 0.5,
    }  # fmt: skip
    path = swim(numbers, {Z: -0.3}, [(0.0, 0.0, 0.0)] * 200)[:, 0]
    assert path[-1, Z] == pytest.approx(0.1 * (0.1 / 0.8 - 0.5), abs=1e-6)


@pytest.mark.parametrize(("z", "left"), [(0.0, 0.6), (-0.05, 0.7), (-0.2, 1.0), (-1.0, 1.0), (0.1, 0.6)])
def test_propellers_near_the_surface(z: float, left: float) -> None:
    """Of a loss of 0.4 over 0.2 m all is felt at the surface and three quarters at a depth of 50 mm."""
    np.testing.assert_allclose(added(surface_loss, z, 0.4, 0.2), (left - 1.0) * THRUST, atol=1e-15)


def test_sideways_thrust_turns() -> None:
    """-4 mN to the left, 20 mm in front of the middle: -80 uN m, and no force."""
    np.testing.assert_allclose(added(side_thrust_lever, -1.0, 0.02), [0.0, 0.0, 0.0, -8e-5], atol=1e-18)
