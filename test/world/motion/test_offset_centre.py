"""A centre of mass off the origin against closed forms, conserved quantities and the same body about its centre."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from cocorosim_ros.world.state.state import SURGE, SWAY, YAW, YAW_RATE, X, Y

Make = Callable[..., Any]
AHEAD, LEFT = 0.013, -0.006  # m, of a Lily of 0.13 m
CENTRE = {"offset_centre.ahead": AHEAD, "offset_centre.left": LEFT}
FREE = {SURGE: 0.06, SWAY: 0.03, YAW: 0.4, YAW_RATE: 0.7}
OFF = (0.0, 0.0, 0.0)


def centre_of(path: Any) -> Any:
    """(rows, 2) where the centre of mass is in the world."""
    cosine, sine = np.cos(path[:, YAW]), np.sin(path[:, YAW])
    return path[:, [X, Y]] + np.column_stack([cosine * AHEAD - sine * LEFT, sine * AHEAD + cosine * LEFT])


@pytest.mark.parametrize("added", [(0.0, 0.0), (0.1, 6e-5)])
def test_forces_accelerate_by_the_whole_matrix(
    acceleration: Make, lily: SimpleNamespace, added: tuple[float, float]
) -> None:
    """M a = tau solved by NumPy, M being Fossen's (2021, eq. 3.49) with added mass on its diagonal; terms by hand."""
    u, v, r, force = 0.05, 0.0, 0.9, (0.004, 0.001)
    numbers = {**CENTRE, "added_mass.sway_minus_surge": added[0], "added_mass.yaw": added[1], "linear_drag.surge": 0.02}
    rates = acceleration(numbers, {SURGE: u, SWAY: v, YAW_RATE: r}, (*force, 0.0))
    mass, about_origin = lily.mass, lily.inertia + lily.mass * (AHEAD**2 + LEFT**2)
    matrix = np.array([
        [mass, 0.0, -mass * LEFT],
        [0.0, mass + added[0], mass * AHEAD],
        [-mass * LEFT, mass * AHEAD, about_origin + added[1]],
    ])  # fmt: skip
    wrench = [
        sum(force) - 0.02 * u + mass * r * (v + AHEAD * r),
        mass * r * (LEFT * r - u),
        lily.lever * (force[1] - force[0]) - mass * r * (AHEAD * u + LEFT * v),
    ]
    assert rates[[0, 1, 3]] == pytest.approx(np.linalg.solve(matrix, wrench), rel=1e-12)


def test_a_free_body_keeps_energy_and_momentum(swim: Make, lily: SimpleNamespace) -> None:
    """1/2 (m (u^2 + v^2) + 2 m r (x v - y u) + I_z r^2), momentum in the world and spin; its centre goes straight."""
    path = swim(CENTRE, FREE, [OFF] * 60, steps=50)[:, 0]
    u, v, r = path[:, SURGE], path[:, SWAY], path[:, YAW_RATE]
    about_origin = lily.inertia + lily.mass * (AHEAD**2 + LEFT**2)
    energy = 0.5 * lily.mass * (u**2 + v**2 + 2.0 * r * (AHEAD * v - LEFT * u)) + 0.5 * about_origin * r**2
    along, aside = lily.mass * (u - LEFT * r), lily.mass * (v + AHEAD * r)
    cosine, sine = np.cos(path[:, YAW]), np.sin(path[:, YAW])
    for kept in (energy, r, along * cosine - aside * sine, along * sine + aside * cosine):
        np.testing.assert_allclose(kept, kept[0], rtol=1e-8)
    speed = np.array([along * cosine - aside * sine, along * sine + aside * cosine])[:, 0] / lily.mass
    wanted = centre_of(path)[0] + 0.5 * np.arange(61)[:, None] * speed
    np.testing.assert_allclose(centre_of(path), wanted, atol=1e-9)
    assert np.ptp(u) > 0.05


def test_a_free_body_with_added_mass_keeps_kirchhoffs_integrals(swim: Make, lily: SimpleNamespace) -> None:
    """Energy of hull and water, and their momentum in the world."""
    added, turning = 0.3, 2e-4
    numbers = {**CENTRE, "added_mass.sway_minus_surge": added, "added_mass.yaw": turning}
    path = swim(numbers, FREE, [OFF] * 60, steps=50)[:, 0]
    u, v, r = path[:, SURGE], path[:, SWAY], path[:, YAW_RATE]
    along, aside = lily.mass * (u - LEFT * r), lily.mass * (v + AHEAD * r) + added * v
    spin = lily.mass * (AHEAD * v - LEFT * u)
    spin += (lily.inertia + lily.mass * (AHEAD**2 + LEFT**2) + turning) * r
    east = along * np.cos(path[:, YAW]) - aside * np.sin(path[:, YAW])
    north = along * np.sin(path[:, YAW]) + aside * np.cos(path[:, YAW])
    about_world = path[:, X] * north - path[:, Y] * east + spin
    for kept in (along * u + aside * v + spin * r, east, north, about_world):
        np.testing.assert_allclose(kept, kept[0], rtol=1e-6)
    assert np.ptp(r) > 0.1


def test_spun_up_about_its_origin_it_turns_about_its_centre(swim: Make, lily: SimpleNamespace) -> None:
    """Opposed thrusters give a moment alone: r = N t / I, the centre of mass rests and the origin circles about it."""
    path = swim(CENTRE, {}, [(-0.3, 0.3, 0.0)] * 12, steps=50)[:, 0]
    time = 0.5 * np.arange(13)
    rate = 2.0 * 0.3 * lily.thrust * lily.lever / lily.inertia
    np.testing.assert_allclose(path[:, YAW_RATE], rate * time, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(path[:, YAW], 0.5 * rate * time**2, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(centre_of(path), [[AHEAD, LEFT]] * 13, atol=1e-8)


def about_centre(lily: SimpleNamespace, fractions: Any, seconds: float) -> Any:
    """(4,) x, y, yaw, r of the origin after rest: Newton's law of the centre of mass in world axes, by SciPy.

    Thrusters and the drag of the origin pull at their places beside the centre.
    """
    left, right = np.asarray(fractions) * lily.thrust
    places = np.array([[-AHEAD, lily.lever - LEFT], [-AHEAD, -lily.lever - LEFT], [-AHEAD, -LEFT]])

    def rate(_: float, s: Any) -> Any:
        yaw, turn = s[2], s[5]
        ahead, aside = np.array([math.cos(yaw), math.sin(yaw)]), np.array([-math.sin(yaw), math.cos(yaw)])
        origin = s[3:5] + turn * (LEFT * ahead - AHEAD * aside)
        drag = -lily.drag * math.hypot(*origin) * origin
        forces = [left * ahead, right * ahead, drag]
        arms = [place[0] * ahead + place[1] * aside for place in places]
        torque = sum(arm[0] * force[1] - arm[1] * force[0] for arm, force in zip(arms, forces, strict=True))
        torque -= lily.yaw_drag * abs(turn) * turn
        return np.concatenate([s[3:5], [turn], sum(forces) / lily.mass, [torque / lily.inertia]])

    start = [AHEAD, LEFT, 0.0, 0.0, 0.0, 0.0]
    end = solve_ivp(rate, (0.0, seconds), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    cosine, sine = math.cos(end[2]), math.sin(end[2])
    return np.array([end[0] - cosine * AHEAD + sine * LEFT, end[1] - sine * AHEAD - cosine * LEFT, end[2], end[5]])


def test_it_is_the_body_about_its_centre_to_fourth_order(swim: Make, lily: SimpleNamespace) -> None:
    """With drag and uneven thrust; half the step leaves a sixteenth of the error, within a fifth."""
    numbers = {**CENTRE, "drag": lily.drag, "yaw_drag": lily.yaw_drag}
    wanted = about_centre(lily, (0.9, 0.5), 20.0)
    errors = []
    for steps in (1, 2, 4):
        row = swim(numbers, {}, [(0.9, 0.5, 0.0)] * 40, steps=steps)[-1, 0]
        errors.append(np.abs(row[[X, Y, YAW, YAW_RATE]] - wanted).max())
    assert errors[-1] < 1e-6
    assert errors[0] / errors[1] == pytest.approx(16.0, rel=0.5)
    assert errors[1] / errors[2] == pytest.approx(16.0, rel=0.2)
