"""Drag of a towed cable against closed forms, an integral by SciPy in axes of the world, and its energy."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
from scipy.integrate import quad

from cocorosim_ros.world.effects.tether_drag import tether_drag
from cocorosim_ros.world.state.state import SURGE, SWAY, YAW, X, Y, Z

Make = Callable[..., Any]
NUMBERS = {"coefficient": 1.2, "diameter": 0.008, "length": 0.0, "x": 0.0, "y": 0.0, "z": 0.0}
ACROSS = 0.5 * 1000.0 * 1.2 * 0.008  # 1/2 rho C_d d [kg/m^2]


def turned(yaw: float, vector: Any) -> Any:
    """A vector (3,) in axes of the world, from those of the body."""
    sine, cosine = math.sin(yaw), math.cos(yaw)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]]) @ vector


def felt(place: Any, velocity: Any, water: Any = (0.0, 0.0, 0.0), yaw: float = 0.0, **numbers: float) -> Any:
    """The force (3,) on the vehicle, all in axes of the world; no moment."""
    row, relative, total = np.zeros(26), np.zeros(4), np.zeros(4)
    row[X : Z + 1], row[YAW] = place, yaw
    row[SURGE : SURGE + 3] = turned(-yaw, np.asarray(velocity, dtype=float))
    relative[:3] = turned(-yaw, np.subtract(velocity, water))
    tether_drag(row, relative, None, np.array([*{**NUMBERS, **numbers}.values()]), total)
    assert total[3] == 0.0
    return turned(yaw, total[:3])


def integrated(place: Any, velocity: Any, water: Any, length: float) -> Any:
    """The same by SciPy: a weight along the cable times |w| w, each piece inclined to the line by a."""
    distance = float(np.linalg.norm(place))
    deployed, line = max(distance, length), np.asarray(place) / distance
    inclined = math.sin(math.acos(distance / deployed))
    across = np.eye(3) - np.outer(line, line) + inclined**1.5 * np.outer(line, line)

    def one(share: float, axis: int) -> float:
        flow = across @ (share * np.asarray(velocity) - np.asarray(water))
        return float(-ACROSS * deployed * share * np.linalg.norm(flow) * flow[axis])

    places = np.linspace(0.0, 1.0, 11)
    return np.array([
        sum(quad(one, low, high, args=(axis,), epsrel=1e-10)[0] for low, high in pairwise(places))
        for axis in range(3)
    ])  # fmt: skip


def test_in_still_water_a_quarter_of_the_cables_own_drag() -> None:
    """5 m straight up to the surface, at 0.4 m/s: 1/2 rho C_d d l V^2 over four, against the motion."""
    force = felt((0.0, 0.0, -5.0), (0.4, 0.0, 0.0), yaw=1.1)
    np.testing.assert_allclose(force, [-ACROSS * 5.0 * 0.4**2 / 4.0, 0.0, 0.0], rtol=1e-12, atol=1e-12)


def test_a_current_pulls_half_of_the_cable() -> None:
    """A vehicle at rest bears half of the drag that 5 m of cable have in a current of 0.3 m/s to the north."""
    force = felt((0.0, 0.0, -5.0), (0.0, 0.0, 0.0), (0.0, 0.3, 0.0), yaw=-0.4)
    np.testing.assert_allclose(force, [0.0, ACROSS * 5.0 * 0.3**2 / 2.0, 0.0], rtol=1e-12, atol=1e-12)


def test_a_cable_that_drifts_along_is_pulled_by_its_upper_part() -> None:
    """Water and vehicle at 0.3 m/s: integral s (1 - s)^2 ds = 1/12 of the drag of the cable at rest in it."""
    force = felt((0.0, 0.0, -5.0), (0.3, 0.0, 0.0), (0.3, 0.0, 0.0))
    np.testing.assert_allclose(force, [ACROSS * 5.0 * 0.3**2 / 12.0, 0.0, 0.0], rtol=1e-12, atol=1e-12)


def test_a_straight_cable_follows_along_its_line_for_nothing() -> None:
    """Away from the anchor no force; a cable of great length in bends has the same drag in every direction."""
    place, away = np.array([3.0, 0.0, -4.0]), np.array([0.3, 0.0, -0.4])
    np.testing.assert_allclose(felt(place, away), 0.0, atol=1e-15)
    np.testing.assert_allclose(felt(place, away, length=500.0), -ACROSS * 500.0 * 0.5 * away / 4.0, rtol=1e-3)
    np.testing.assert_allclose(
        felt(place, away, length=10.0), -ACROSS * 10.0 * math.sin(math.acos(0.5)) ** 3 * 0.5 * away / 4.0, rtol=1e-12
    )


def test_it_is_the_integral_along_the_cable() -> None:
    """Of 60 random places, headings, velocities, currents and lengths; within 3e-4 of both special cases together."""
    rng = np.random.default_rng(5)
    for number in range(60):
        place, yaw, length = rng.uniform(-4.0, 4.0, 3), rng.uniform(-4.0, 4.0), rng.choice([0.0, 5.0, 20.0])
        velocity, water = (rng.standard_normal(3) * 10.0 ** rng.uniform(-2, 0) for _ in range(2))
        if number % 3 == 0:  # the cable is slowest somewhere along its length
            water = rng.uniform(0.0, 1.0) * velocity + 0.1 * water
        scale = ACROSS * max(float(np.linalg.norm(place)), length)
        scale *= float(velocity @ velocity) / 4.0 + float(water @ water) / 2.0
        found = felt(place, velocity, water, yaw, length=length)
        np.testing.assert_allclose(found, integrated(place, velocity, water, length), rtol=0.0, atol=3e-4 * scale)


def test_it_takes_energy_and_gives_none() -> None:
    """In still water its power is below zero, in 200 random states."""
    rng = np.random.default_rng(6)
    for _ in range(200):
        place, velocity = rng.uniform(-4.0, 4.0, 3), rng.standard_normal(3)
        assert felt(place, velocity, yaw=rng.uniform(-3.0, 3.0), length=rng.uniform(0.0, 10.0)) @ velocity < 0.0


def test_at_its_anchor_there_is_no_cable() -> None:
    """No distance and no length: no force, and no division by zero; with a length it is all bends."""
    np.testing.assert_array_equal(felt((0.0, 0.0, 0.0), (0.4, 0.1, 0.0)), 0.0)
    np.testing.assert_allclose(
        felt((0.0, 0.0, 0.0), (0.4, 0.0, 0.0), length=5.0), [-ACROSS * 5.0 * 0.16 / 4.0, 0.0, 0.0], rtol=1e-12
    )


def test_the_simulators_water_flows_past_the_cable(acceleration: Make, lily: SimpleNamespace) -> None:
    """A Lily at rest, 2 m below its anchor, in a current of 0.1 m/s that only the cable feels."""
    numbers = {f"tether_drag.{name}": value for name, value in NUMBERS.items()}
    numbers |= {"tether_drag.x": 1.0, "tether_drag.y": -2.0, "steady_current.x": 0.1}
    rates = acceleration(numbers, {X: 1.0, Y: -2.0, Z: -2.0, YAW: math.pi / 2})
    np.testing.assert_allclose(rates[:2] * lily.mass, [0.0, -ACROSS * 2.0 * 0.01 / 2.0], rtol=1e-9, atol=1e-12)


def test_a_lily_coasts_down_by_its_cable(swim: Make, lily: SimpleNamespace) -> None:
    """Sideways to a long cable: v0 / (1 + k v0 t / m) with k = 1/8 rho C_d d l; the cable hardly turns meanwhile."""
    numbers = {f"tether_drag.{name}": value for name, value in NUMBERS.items()} | {"tether_drag.x": 40.0}
    path = swim(numbers, {SWAY: 0.02, Z: 0.0}, [(0.0, 0.0, 0.0)] * 20)[:, 0]
    time = 0.5 * np.arange(21)
    slowed = 0.02 / (1.0 + ACROSS * 40.0 / 4.0 * 0.02 * time / lily.mass)
    np.testing.assert_allclose(path[:, SWAY], slowed, rtol=1e-4)
