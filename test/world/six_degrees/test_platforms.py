"""The platforms with six degrees of freedom move as what was published of them says."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.platform import load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.world.six_degrees.bodies import Body, build_bodies
from cocorosim_ros.world.six_degrees.description import vehicle_of
from cocorosim_ros.world.six_degrees.dynamics import state_rate
from cocorosim_ros.world.vehicle_model.curves import forces_at

TO_THESIS = np.array([1, -1, -1, 1, -1, -1])  # forward-left-up to forward-right-down
AXES = "uvwpqr"


def wrench_of_water(velocity: Any, effort: Any = (0.0, 0.0, 0.0)) -> Any:
    """(6,) what the water does to a REMUS 100 that moves with `velocity` (6,), both in the axes of the thesis.

    Added mass times acceleration, where the hull itself has next to no mass: 1e-9 of what it has.
    """
    whole = vehicle_of(load_platform("remus100"))
    light = replace(whole, mass=1e-9 * whole.mass, inertia=1e-9 * whole.inertia, weight=0.0, buoyancy=0.0)
    numbers = build_bodies([light])
    body = Body(*(getattr(numbers, name)[0] for name in Body._fields[:-1]), np.zeros(0))
    row, rate = np.zeros(13), np.zeros(13)
    row[6], row[7:] = 1.0, np.asarray(velocity) * TO_THESIS
    state_rate(row, 0.0, np.array(effort, dtype=np.float64), body, rate)
    return light.mass_matrix() @ rate[7:] * TO_THESIS


@pytest.mark.parametrize(
    ("force", "pair", "published"),
    [
        ("v", "uv", -28.6), ("w", "uw", -28.6), ("q", "uw", 24.0), ("r", "uv", -24.0),
        ("v", "ur", 5.22), ("w", "uq", -5.22), ("q", "uq", -2.00), ("r", "ur", -2.00),
        ("v", "wp", 35.5), ("w", "vp", -35.5), ("q", "vp", -1.93), ("r", "wp", -1.93),
        ("v", "pq", 1.93), ("w", "rp", 1.93), ("q", "rp", 4.86), ("r", "pq", -4.86),
        ("u", "wq", -35.5), ("u", "vr", 35.5), ("u", "qq", -1.93), ("u", "rr", -1.93),
    ],
)  # fmt: skip
def test_remus_has_the_published_cross_terms(force: str, pair: str, published: float) -> None:
    """Y_uv and the others of Prestero (2001), of which only added mass, fins and the hull's lift are in the file.

    A cross term is the mixed difference of the force over both velocities, at positive ones. Tolerances: the table
    rounds to 0.05; 4.86 leaves out 2 % of the roll's added inertia, and the thesis has 0.2 % less.
    """
    first, second = (AXES.index(axis) for axis in pair)

    def at(a: float, b: float) -> float:
        velocity = np.zeros(6)
        velocity[first] += a
        if pair[0] != pair[1]:
            velocity[second] += b
        return float(wrench_of_water(velocity)[AXES.index(force)])

    found = at(1.0, 1.0) - at(1.0, 0.0) - at(0.0, 1.0) + at(0.0, 0.0) if pair[0] != pair[1] else at(1.0, 0.0)
    assert found == pytest.approx(published, abs=0.06)


def test_remus_fins_have_the_published_coefficients() -> None:
    """Fins at 0.1 rad and 1.54 m/s: 9.64 u^2 and 6.15 u^2 for each radian, as Prestero's Y_uudr and M_uuds."""
    found = wrench_of_water([1.54, 0, 0, 0, 0, 0], [0.0, 0.1, 0.0])
    assert abs(found[1]) == pytest.approx(9.64 * 1.54**2 * 0.1, rel=1e-4)
    assert abs(found[5]) == pytest.approx(6.15 * 1.54**2 * 0.1, rel=1e-3)
    found = wrench_of_water([1.54, 0, 0, 0, 0, 0], [0.0, 0.0, 0.1])
    assert found[2] == pytest.approx(-9.64 * 1.54**2 * 0.1, rel=1e-4)  # upwards is down in the thesis' axes
    assert found[4] == pytest.approx(-6.15 * 1.54**2 * 0.1, rel=1e-3)  # at the stern: the bow goes down


def test_remus_keeps_the_speed_of_its_trials() -> None:
    """Its propeller's 3.86 N balance the drag at 1.54 m/s (Prestero 2001), to the digits of these."""
    assert wrench_of_water([1.54, 0, 0, 0, 0, 0], [3.86, 0, 0])[0] == pytest.approx(0.0, abs=0.03)


def test_bluerov_allocation_is_the_published_one() -> None:
    """Forces and arms of von Benzon et al. (2022): 45 deg, 0.1888 m in yaw, 0.218 m in roll, 0.12 m in pitch."""
    wrench = vehicle_of(load_platform("bluerov2_heavy")).wrench
    assert np.abs(wrench[:4, :2]) == pytest.approx(np.full((4, 2), math.sqrt(0.5)), rel=1e-12)
    assert np.abs(wrench[:4, 5]) == pytest.approx(np.full(4, 0.1888), abs=5e-5)
    assert np.abs(wrench[4:, 3:5]) == pytest.approx(np.tile([0.218, 0.12], (4, 1)), rel=1e-12)
    assert np.linalg.matrix_rank(wrench) == 6
    assert wrench[:4].sum(axis=0) == pytest.approx([4 * math.sqrt(0.5), 0, 0, 0, -0.34 * math.sqrt(0.5), 0], abs=1e-12)


def test_bluerov_thrusters_push_by_the_published_curve() -> None:
    """80 / (1 + exp(-4 V^3)) - 40 N, at the points of the table and to 0.08 N between them."""
    asked = np.linspace(-1.0, 1.0, 401)
    force = forces_at(load_platform("bluerov2_heavy"), np.tile(asked[:, np.newaxis], 8))
    apart = np.abs(force - (80.0 / (1.0 + np.exp(-4.0 * asked**3)) - 40.0)[:, np.newaxis])
    assert apart[::10].max() < 1e-4
    assert apart.max() < 0.08


@pytest.mark.parametrize("name", ["bluerov2_heavy", "remus100"])
def test_platform_survives_being_written(name: str) -> None:
    """What a run notes of its platform reads back as the same."""
    platform = load_platform(name)
    assert read_platform(entry_of(platform_tree(platform), "written")) == platform
