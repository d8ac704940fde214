"""A vehicle that nothing makes roll or pitch moves in six degrees of freedom as `world.motion` moves it in four."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

Make = Callable[..., Any]
COMMAND = [0.7, -0.3, 0.4, 0.5, 0.5]
VELOCITY = [0.4, -0.2, 0.1, 0.3]


@pytest.fixture(scope="module")
def platform() -> Any:
    """A platform with drag of each axis by itself, linear drag, a trim, and five thrusters."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    return load_platform("tauv_pool")


@pytest.fixture(scope="module")
def in_four(platform: Any) -> Any:
    """x, y, z, yaw, u, v, w, r after 20 s at steps of 20 ms by `world.motion`."""
    from cocorosim_ros.world.motion.contact import CONTACT_CODE
    from cocorosim_ros.world.motion.integrators import INTEGRATOR_CODE
    from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
    from cocorosim_ros.world.state.state import row_size
    from cocorosim_ros.world.surroundings.tank import Tank
    from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

    far = np.full(3, 1e4)
    tank = Tank(-far, far, np.zeros((0, 4)), np.zeros((0, 6)))
    vehicles = build_vehicles([platform])
    state = np.zeros((1, 1, row_size(5)))
    state[0, 0, 2], state[0, 0, 4:8] = -100.0, VELOCITY
    stepping = Stepping(INTEGRATOR_CODE["rk4"], 1000, 0.02, CONTACT_CODE[next(iter(CONTACT_CODE))])
    apply_commands(state, np.array([[COMMAND]]), vehicles)
    move(state, vehicles, tank, stepping, np.zeros(0), 0.0)
    return state[0, 0, :8].copy()


@pytest.fixture(scope="module")
def vehicle(platform: Any) -> Any:
    """The same numbers as matrices, with the buoyancy 10 cm above the weight, and damped in roll and pitch."""
    from cocorosim_ros.world.six_degrees.vehicle import Vehicle

    drag = platform.effects["linear_drag"]
    weight = platform.mass * platform.gravity
    wrench = np.zeros((5, 6))
    wrench[:, [0, 1, 2, 5]] = platform.actuator_wrenches()
    return Vehicle(
        mass=platform.mass, inertia=np.diag([1.5, 1.8, platform.yaw_inertia]), weight=weight,
        buoyancy=weight + platform.effects["buoyancy_trim"]["force"], centre_of_buoyancy=np.array([0.0, 0.0, 0.1]),
        linear=np.diag([drag["surge"], drag["sway"], drag["heave"], 4.0, 4.0, drag["yaw"]]),
        quadratic=np.diag([platform.drag] * 3 + [1.0, 1.0, platform.yaw_drag]),
        wrench=wrench, limit=platform.actuator_limits(), density=platform.water_density,
    )  # fmt: skip


def as_four(row: Any) -> Any:
    """x, y, z, yaw, u, v, w, r of a state in six degrees of freedom."""
    yaw = Rotation.from_quat(row[3:7]).as_euler("xyz")[2]
    return np.array([*row[:3], yaw, *row[7:10], row[12]])


def aligned(row: Any) -> Any:
    """The same with the yaw within a turn."""
    return np.array([*row[:3], np.angle(np.exp(1j * row[3])), *row[4:]])


def test_without_roll_and_pitch_both_motions_agree(swim: Make, start: Make, vehicle: Any, in_four: Any) -> None:
    """Nothing rolls or pitches it: both integrate the same equations, to the error of the step (1e-8 at 20 ms)."""
    velocity = [*VELOCITY[:3], 0.0, 0.0, VELOCITY[3]]
    end = swim(vehicle, start(velocity), 20.0, 0.02, COMMAND)[-1]
    assert end[[3, 4, 10, 11]] == pytest.approx(np.zeros(4), abs=1e-15)
    assert as_four(end) == pytest.approx(aligned(in_four), abs=1e-7)


def test_strong_restoring_moment_leads_to_four_degrees(swim: Make, start: Make, vehicle: Any, in_four: Any) -> None:
    """Thrust 5 cm below the centre pitches it; each tenfold restoring moment brings it about ten times nearer."""
    velocity = [*VELOCITY[:3], 0.0, 0.0, VELOCITY[3]]
    low = vehicle.wrench.copy()
    low[0, 4] = -0.05
    apart = []
    for height in (0.1, 1.0, 10.0):
        stiff = replace(vehicle, wrench=low, centre_of_buoyancy=np.array([0.0, 0.0, height]))
        end = swim(stiff, start(velocity), 20.0, 0.005, COMMAND)[-1]
        apart.append(np.abs(as_four(end)[:3] - in_four[:3]).max())
    assert apart[0] > 1e-3
    assert apart[1] < 0.2 * apart[0]
    assert apart[2] < 0.2 * apart[1]
