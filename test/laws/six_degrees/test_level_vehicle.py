"""A platform with six_degrees in four: as long as it is held level, both are accelerated alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.world.motion.contact import CONTACT_CODE
from cocorosim_ros.world.motion.integrators import INTEGRATOR_CODE
from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
from cocorosim_ros.world.six_degrees.bodies import Body, build_bodies
from cocorosim_ros.world.six_degrees.description import vehicle_of
from cocorosim_ros.world.six_degrees.dynamics import state_rate
from cocorosim_ros.world.state.state import row_size
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.curves import forces_at
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

SHIPPED = Path(__file__).parents[3] / "config/platforms"
LEVEL = [0, 1, 2, 5]
STEP = 1e-6
LOPSIDED = (
    ("centre_of_gravity: {value: [0, 0, -0.0196]", "centre_of_gravity: {value: [0.11, -0.04, -0.0196]"),
    ("linear_damping: {value: [0, 0, 0]", "linear_damping: {value: [3, 4, 5]"),
    ("linear_turn_damping: {value: [0, 0, 0]", "linear_turn_damping: {value: [1, 1, 2]"),
    (
        "    - {matrix: lift, force: sway, motion: sway,",
        "    - {matrix: added_mass, force: yaw, motion: surge, number: {value: 0.7, unit: kg m, source: made up}}\n"
        "    - {matrix: lift, force: surge, motion: surge, number: {value: 2.2, unit: kg/m, source: made up}}\n"
        "    - {matrix: lift, force: sway, motion: yaw, number: {value: 3.1, unit: kg, source: made up}}\n"
        "    - {matrix: lift, force: yaw, motion: yaw, number: {value: 1.3, unit: kg m, source: made up}}\n"
        "    - {matrix: lift, force: sway, motion: sway,",
    ),
)
UNCARRIED = (
    "    - {matrix: quadratic_damping, force: sway, motion: yaw,",
    "    - {matrix: quadratic_damping, force: yaw, motion: sway,",
)


@pytest.fixture(scope="module")
def platform(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Platform]:
    """Function of a name: a platform; `lopsided` is a torpedo heavy ahead and to the right, with couplings and lift.

    Neither it nor `torpedo`, the REMUS 100, has the couplings that are left out in four degrees of freedom.
    """

    def make(name: str) -> Platform:
        if name == "bluerov2_heavy":
            return load_platform(name)
        text = (SHIPPED / "remus100.yaml").read_text("utf-8")
        for old, new in LOPSIDED if name == "lopsided" else ():
            assert old in text
            text = text.replace(old, new)
        lines = [line for line in text.splitlines() if not line.startswith(UNCARRIED)]
        path = tmp_path_factory.mktemp("platforms") / f"{name}.yaml"
        path.write_text("\n".join(lines), "utf-8")
        return load_platform(path)

    return make


def held_level(platform: Platform, velocity: Any, command: Any) -> Any:
    """(4,) accelerations of u, v, w, r in six degrees of freedom while something holds roll and pitch at zero."""
    vehicle, bodies = vehicle_of(platform), build_bodies([vehicle_of(platform)])
    body = Body(*(getattr(bodies, name)[0] for name in Body._fields[:-1]), np.zeros(0))
    row, rate = np.zeros(13), np.zeros(13)
    row[6], row[[7, 8, 9, 12]] = 1.0, velocity
    state_rate(row, 0.0, forces_at(platform, np.array([command]))[0], body, rate)
    matrix = vehicle.mass_matrix()
    return np.linalg.solve(matrix[np.ix_(LEVEL, LEVEL)], (matrix @ rate[7:])[LEVEL])


def after(platform: Platform, velocity: Any, command: Any, seconds: float, step: float) -> Any:
    """(4,) u, v, w, r of a platform in four degrees of freedom that began with a velocity in deep water."""
    far, vehicles = np.full(3, 1e4), build_vehicles([platform])
    tank = Tank(-far, far, np.zeros((0, 4)), np.zeros((0, 6)))
    state = np.zeros((1, 1, row_size(len(command))))
    state[0, 0, 2], state[0, 0, 4:8] = -100.0, velocity
    stepping = Stepping(INTEGRATOR_CODE["rk4"], round(seconds / step), step, CONTACT_CODE["inelastic"])
    apply_commands(state, np.array([[command]]), vehicles)
    move(state, vehicles, tank, stepping, np.zeros(0), 0.0)
    return state[0, 0, 4:8].copy()


@pytest.mark.parametrize("name", ["bluerov2_heavy", "torpedo", "lopsided"])
def test_both_are_accelerated_alike(platform: Callable[[str], Platform], name: str) -> None:
    """At thirty velocities and commands, to the error of a difference over a microsecond."""
    six, draw = platform(name), np.random.default_rng(8)
    four = in_four_degrees(six)
    for _ in range(30):
        velocity = draw.uniform(-1.0, 1.0, 4) * [1.5, 0.6, 0.6, 0.8]
        command = draw.uniform(-1.0, 1.0, len(six.actuators))
        found = (after(four, velocity, command, STEP, STEP) - velocity) / STEP
        assert found == pytest.approx(held_level(six, velocity, command), rel=1e-4, abs=1e-4)


@pytest.mark.parametrize(
    ("command", "axis", "force", "linear", "quadratic"),
    [
        ([0.5] * 4 + [0.0] * 4, 0, 4 * 9.7967 / math.sqrt(2.0), 13.7, 141.0),
        ([0.5, -0.5, -0.5, 0.5] + [0.0] * 4, 1, 4 * 9.7967 / math.sqrt(2.0), 0.0, 217.0),
        ([0.0] * 8, 2, -(13.5 - 13.4) * 9.82, 33.0, 190.0),
    ],
)
def test_terminal_speeds_of_the_bluerov(command: Any, axis: int, force: float, linear: float, quadratic: float) -> None:
    """Ahead, to the left, and as it sinks: |F| = d v + k v^2, with the numbers of von Benzon et al. (2022)."""
    speed = (math.sqrt(linear**2 + 4.0 * quadratic * abs(force)) - linear) / (2.0 * quadratic)
    end = after(in_four_degrees(load_platform("bluerov2_heavy")), [0.0] * 4, command, 60.0, 0.02)
    assert end[axis] == pytest.approx(math.copysign(speed, force), rel=1e-6)
