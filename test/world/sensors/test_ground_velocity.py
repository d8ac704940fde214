"""The velocity over ground beside that through the water: in a current they differ by the current along the hull."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors import ERROR_COLUMNS, NEUTRAL
from cocorosim_ros.world.sensors.faults import add_errors
from cocorosim_ros.world.terms.motors import Motors
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS

Make = Callable[..., Any]
CURRENT = (0.03, -0.05)  # m/s east and north
MOTION = (0.3, -0.1, 0.02, 0.4)  # u, v, w [m/s] over ground, r [rad/s]


def in_a_current(make_simulation: Make, yaw: float) -> Any:
    """A Lily with both logs that heads along `yaw` [rad] and moves by MOTION in CURRENT."""
    simulation = make_simulation([[[0.0, 0.0, -1.0, yaw]]])
    simulation.world.instruments.measured[...] = True
    simulation.state[0, 0, 4:8] = MOTION
    vehicles = simulation.world.vehicles
    vehicles.active[:] |= EFFECT_BIT["steady_current"]
    for name, value in zip("xy", CURRENT, strict=True):
        vehicles.parameters[..., PARAMETER_COLUMNS[f"steady_current.{name}"]] = value
    return simulation


@pytest.mark.parametrize("yaw", [0.0, 0.5 * math.pi, math.pi, 2.1])
def test_they_differ_by_the_current_along_the_hull(make_simulation: Make, yaw: float) -> None:
    """The log over ground shows the state itself; less the other it is the current, turned by the heading."""
    shown = in_a_current(make_simulation, yaw).sense()
    ground, water = shown.ground_velocity[0, 0], shown.velocity[0, 0]
    assert ground.tolist() == list(MOTION[:3])
    east, north = CURRENT
    along = [east * math.cos(yaw) + north * math.sin(yaw), north * math.cos(yaw) - east * math.sin(yaw), 0.0]
    np.testing.assert_allclose(ground - water[:3], along, atol=1e-15)
    assert water[3] == MOTION[3]


def test_it_is_nan_where_it_is_not_measured(make_simulation: Make) -> None:
    """A robot without the log shows NaN in all three."""
    simulation = make_simulation([[[0.0, 0.0, -1.0, 0.0]]])
    simulation.world.instruments.measured[0, list(SENSORS).index("ground_velocity")] = False
    assert np.isnan(simulation.sense().ground_velocity[0, 0]).all()


def test_its_errors_are_those_of_what_it_measures(make_simulation: Make) -> None:
    """Turned by an angle whose sine is 0.6, and 10 % too much: 1.1 (0.8 u + 0.6 v, 0.8 v - 0.6 u, w) over ground.

    The log through the water beside it stays as it is.
    """
    simulation = in_a_current(make_simulation, 0.7)
    right, shown = simulation.sense().velocity[0, 0].copy(), simulation.sense()
    error = np.array([NEUTRAL])
    error[0, ERROR_COLUMNS["ground_log_misalignment.angle"]] = math.asin(0.6)
    error[0, ERROR_COLUMNS["ground_log_scale.scale"]] = 1.1
    vehicles = simulation.world.vehicles
    motors = Motors(vehicles.is_pump, vehicles.actuator_curve, vehicles.actuator_limit)
    add_errors(5.0, error, simulation.state, motors, shown)
    expected = 1.1 * np.array([0.8 * 0.3 - 0.06, -0.08 - 0.18, 0.02])
    np.testing.assert_allclose(shown.ground_velocity[0, 0], expected, atol=1e-15)
    np.testing.assert_array_equal(shown.velocity[0, 0], right)


PLATFORM = """name: logged
description: a vehicle with a log of either kind
based_on: BASE
sensors: {compass: true, pressure: true, imu: true, velocity: true, ground_velocity: true}
"""
SCENARIO = """name: logged
description: one vehicle in a steady current
seed: 1
tick: 0.5 s
duration: 20 s
tank: {size: [40 m, 40 m, 20 m]}
integrator: {name: rk4, step: 0.05 s, contact: inelastic}
water: {currents: [{kind: uniform, x: 0.03 m/s, y: -0.05 m/s}]}
swarm:
  - platform: PLATFORM
    prefix: auv
    controller: programme
    overrides: {row_1_time: 8 s, row_1_ahead: 0.6, row_2_time: 12 s, row_2_ahead: 0.5, row_2_turn: 0.3}
    start: {poses: [[0 m, 0 m, -5 m, 40 deg]]}
lockstep: {silent_controller: thrusters_off, patience: 10 s}
recording: {topics: all}
"""


@pytest.fixture
def scenario(tmp_path: Path) -> Callable[[str], Path]:
    """Function of the name of a platform: the scenario of one that is based on it, as a file."""

    def make(base: str) -> Path:
        (tmp_path / "logged.yaml").write_text(PLATFORM.replace("BASE", base))
        (tmp_path / "swim.yaml").write_text(SCENARIO.replace("PLATFORM", str(tmp_path / "logged.yaml")))
        return tmp_path / "swim.yaml"

    return make


@pytest.mark.parametrize("base", ["lily", "bluerov2_heavy"])
def test_a_platform_may_carry_it(base: str, scenario: Callable[[str], Path]) -> None:
    """Turned into the world the two logs differ by the current at every moment, and the one shows the true motion.

    The second vehicle rolls and pitches: its logs stand along its own axes.
    """
    from scipy.spatial.transform import Rotation

    run = cocorosim.simulate(scenario(base))
    ground, water = run.readings["ground_velocity"][:, 0], run.readings["velocity"][:, 0, :3]
    np.testing.assert_array_equal(ground, run.velocity[:, 0])
    apart = Rotation.from_quat(run.attitude[:, 0]).apply(ground - water)
    np.testing.assert_allclose(apart, np.tile([*CURRENT, 0.0], (len(ground), 1)), atol=1e-12)
    assert np.ptp(ground[:, 0]) > 0.01


def test_it_is_recorded(scenario: Callable[[str], Path], tmp_path: Path) -> None:
    """As it was simulated, in messages that say of turns that nothing measured them."""
    made = scenario("lily")
    recorded = cocorosim.record(made, tmp_path / "bag").readings["auv_01"]["ground_velocity"]
    shown = np.column_stack([recorded.column(name) for name in "uvw"])
    np.testing.assert_array_equal(shown, cocorosim.simulate(made).readings["ground_velocity"][:, 0])
    assert all(np.isnan(recorded.column(name)).all() for name in "pqr")
