"""Manoeuvres of the platforms with six degrees of freedom, against the equations of motion of their publications.

The equations stand here as they are published, in forward-right-down axes and Euler angles, and scipy integrates them;
a scenario of the simulator, which has matrices, quaternions and fins that feel their own flow, is commanded the same.

Sources: Prestero, Verification of a Six-Degree of Freedom Simulation Model for the REMUS Autonomous Underwater Vehicle
(MIT and WHOI, 2001), with the coefficients of its appendix; von Benzon et al., J. Mar. Sci. Eng. 10(12), 1898 (2022).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.six_degrees.state import SURGE
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

COLUMNS = ("u", "v", "w", "p", "q", "r", "x", "y", "z", "phi", "theta", "psi")
U, V, W, P, Q, R, X, Y, Z, PHI, THETA, PSI = range(12)
TICK, TURNED = 0.1, np.array([1, -1, -1])  # s; from forward-left-up to forward-right-down
SCENARIO = """\
name: manoeuvre
description: one vehicle plays commands, far from walls
seed: 1
tick: 0.1 s
duration: 100 s
tank: {{size: [400 m, 400 m, 200 m]}}
integrator: {{name: rk4, step: 0.02 s, contact: inelastic}}
swarm:
  - platform: {platform}
    prefix: vehicle
    controller: programme
    overrides: {{{overrides}}}
    start: {{poses: [[0 m, 0 m, -100 m, 0 deg]]}}
"""
Phases = Sequence[tuple[float, Sequence[float]]]  # seconds, and what is commanded meanwhile


def played(phases: Phases) -> dict[str, float | str]:
    """Settings of the controller `programme`, which knows three motions: each of up to three phases is one of them."""
    motions = ("ahead", "turn", "rise")
    settings: dict[str, float | str] = {f"actuator_{n}_{motion}": 0.0 for n in range(1, 9) for motion in motions}
    for row, ((seconds, commands), motion) in enumerate(zip(phases, motions, strict=False), start=1):
        settings |= {f"row_{row}_time": f"{seconds} s", f"row_{row}_{motion}": 1.0}
        settings |= {f"actuator_{n}_{motion}": float(command) for n, command in enumerate(commands, start=1)}
    return settings


def swum(folder: Path, platform: str, phases: Phases, speed: float = 0.0) -> Any:
    """(ticks, 12) the simulator's motion in the publications' axes; `speed` at first, where scenarios begin at rest."""
    path = folder / "manoeuvre.yaml"
    overrides = ", ".join(f"{key}: {value}" for key, value in played(phases).items())
    path.write_text(SCENARIO.format(platform=platform, overrides=overrides))
    scenario = load_scenario(path)
    simulation = Simulation(build_world(scenario), start_poses(scenario, 0)[np.newaxis])
    simulation._rolling.state[..., SURGE] = speed
    rows = []
    for _ in range(round(sum(seconds for seconds, _ in phases) / TICK) + 1):
        turns = Rotation.from_quat(simulation.attitude[0, 0]).as_euler("xyz")
        place = simulation.state[0, 0, :3] + [0.0, 0.0, 100.0]
        parts = (simulation.velocity[0, 0], simulation.sense().angular_rate[0, 0], place, turns)
        rows.append(np.concatenate([part * TURNED for part in parts]))
        simulation.decide()
        simulation.advance()
    motion = np.array(rows)
    motion[:, PSI] = np.unwrap(motion[:, PSI])
    return motion


def integrated(rates: Callable[..., Any], phases: Phases, speed: float = 0.0) -> Any:
    """(ticks, 12) what the published equations do."""
    pieces = [np.eye(1, 12) * speed]
    for seconds, commands in phases:
        times, start = np.arange(1, round(seconds / TICK) + 1) * TICK, pieces[-1][-1]
        span, exact = (0.0, times[-1]), {"rtol": 1e-9, "atol": 1e-12}
        pieces.append(solve_ivp(rates, span, start, "DOP853", times, args=(commands,), **exact).y.T)
    return np.vstack(pieces)


def assert_near(found: Any, expected: Any, share: float, columns: Sequence[int] = range(12)) -> None:
    """Of each column the difference stays at all times below `share` of the largest value that the column has."""
    largest, apart = np.abs(expected).max(axis=0), np.abs(found - expected).max(axis=0)
    beyond = [column for column in columns if apart[column] > share * largest[column] + 1e-9]
    assert beyond == [], {COLUMNS[column]: (apart[column], largest[column]) for column in beyond}


def with_kinematics(state: Any, accelerations: Any) -> list[float]:
    """The derivative (12,) of a state, of which `accelerations` are the first half; Euler angles phi, theta, psi."""
    u, v, w, p, q, r = state[:6]
    (s1, s2, s3), (c1, c2, c3) = np.sin(state[PHI:]), np.cos(state[PHI:])
    return [
        *accelerations,
        c3 * c2 * u + (c3 * s2 * s1 - s3 * c1) * v + (s3 * s1 + c3 * c1 * s2) * w,
        s3 * c2 * u + (c1 * c3 + s1 * s2 * s3) * v + (c1 * s2 * s3 - c3 * s1) * w,
        -s2 * u + c2 * s1 * v + c1 * c2 * w,
        p + s1 * s2 / c2 * q + c1 * s2 / c2 * r,
        c1 * q - s1 * r,
        s1 / c2 * q + c1 / c2 * r,
    ]


WEIGHT, BUOYANCY, Z_G, THRUST = 299.0, 306.0, 0.0196, 3.86
MASS, I_XX, I_YY, I_ZZ = WEIGHT / 9.81, 0.177, 3.45, 3.45
X_UU, X_WQ, X_QQ, X_VR, X_RR = -1.62, -35.5, -1.93, 35.5, -1.93
Y_VV, Y_RR, Y_UV, Y_WP, Y_UR, Y_PQ, Y_UUDR = -1310.0, 0.632, -28.6, 35.5, 5.22, 1.93, 9.64
Z_WW, Z_QQ, Z_UW, Z_UQ, Z_VP, Z_RP, Z_UUDS = -131.0, -0.632, -28.6, -5.22, -35.5, 1.93, -9.64
K_PP = -0.130
M_WW, M_QQ, M_RP, M_UQ, M_UW, M_VP, M_UUDS = 3.18, -188.0, 4.86, -2.00, 24.0, -1.93, -6.15
N_VV, N_RR, N_UV, N_PQ, N_WP, N_UR, N_UUDR = -3.18, -94.0, -24.0, -4.86, -1.93, -2.00, -6.15
X_UDOT, Y_VDOT, Y_RDOT, Z_WDOT, Z_QDOT = -0.930, -35.5, 1.93, -35.5, -1.93
K_PDOT, M_WDOT, M_QDOT, N_VDOT, N_RDOT = -0.0704, -1.93, -4.88, 1.93, -4.88
REMUS_INVERSE = np.linalg.inv([
    [MASS - X_UDOT, 0, 0, 0, MASS * Z_G, 0],
    [0, MASS - Y_VDOT, 0, -MASS * Z_G, 0, -Y_RDOT],
    [0, 0, MASS - Z_WDOT, 0, -Z_QDOT, 0],
    [0, -MASS * Z_G, 0, I_XX - K_PDOT, 0, 0],
    [MASS * Z_G, 0, -M_WDOT, 0, I_YY - M_QDOT, 0],
    [0, -N_VDOT, 0, 0, 0, I_ZZ - N_RDOT],
])  # fmt: skip
FASTEST, STOP = 1.54, math.radians(13.6)  # m/s of the trials; largest angle of fins
LEVEL = math.radians(-9.38)  # delta_s at which these equations, 7 N too light, go straight at their depth and 1.48 m/s


def remus(_: float, state: Any, commands: Sequence[float]) -> list[float]:
    """Prestero's equations without the propeller's torque; commands: thrust [N], delta_r and delta_s [rad]."""
    u, v, w, p, q, r = state[:6]
    thrust, rudder, planes = commands
    (s1, s2), (c1, c2) = np.sin(state[PHI:PSI]), np.cos(state[PHI:PSI])
    net, low = WEIGHT - BUOYANCY, MASS * Z_G
    wrench = [
        -net * s2 + X_UU * u * abs(u) + (X_WQ - MASS) * w * q + X_QQ * q * q
        + (X_VR + MASS) * v * r + X_RR * r * r - low * p * r + thrust,
        net * c2 * s1 + Y_VV * v * abs(v) + Y_RR * r * abs(r) + Y_UV * u * v + (Y_WP + MASS) * w * p
        + (Y_UR - MASS) * u * r - low * q * r + Y_PQ * p * q + Y_UUDR * u * u * rudder,
        net * c2 * c1 + Z_WW * w * abs(w) + Z_QQ * q * abs(q) + Z_UW * u * w + (Z_UQ + MASS) * u * q
        + (Z_VP - MASS) * v * p + low * (p * p + q * q) + Z_RP * r * p + Z_UUDS * u * u * planes,
        -Z_G * WEIGHT * c2 * s1 + K_PP * p * abs(p) - (I_ZZ - I_YY) * q * r - low * w * p + low * u * r,
        -Z_G * WEIGHT * s2 + M_WW * w * abs(w) + M_QQ * q * abs(q) + (M_RP - (I_XX - I_ZZ)) * r * p
        + low * v * r - low * w * q + M_UQ * u * q + M_UW * u * w + M_VP * v * p + M_UUDS * u * u * planes,
        N_VV * v * abs(v) + N_RR * r * abs(r) + N_UV * u * v + (N_PQ - (I_YY - I_XX)) * p * q
        + N_WP * w * p + N_UR * u * r + N_UUDR * u * u * rudder,
    ]  # fmt: skip
    return with_kinematics(state, REMUS_INVERSE @ wrench)


def both_remus(folder: Path, phases: Phases, speed: float) -> tuple[Any, Any]:
    """Found and expected motion under thrust [N] and the platform's fin angles [rad]; delta_r has the other sign."""
    found = swum(folder, "remus100", [(s, (t / THRUST, r / STOP, d / STOP)) for s, (t, r, d) in phases], speed)
    return found, integrated(remus, [(s, (t, -r, d)) for s, (t, r, d) in phases], speed)


def test_remus_turns_as_published(tmp_path: Path) -> None:
    """Rudders of 4 deg for 25 s move and roll it as published to 0.5 %, in circles of the same radius to 0.1 %.

    A positive rudder of the platform turns to the right, and the vehicle leans inwards; a negative one mirrors that.
    Tolerance: Prestero rounds sums of coefficients to three digits and leaves K_pdot out of M_rp; 0.3 % of pitch rate.
    """
    rudder = math.radians(4.0)
    right, left = (both_remus(tmp_path, [(25.0, (THRUST, side * rudder, LEVEL))], FASTEST) for side in (1.0, -1.0))
    for found, expected in (right, left):
        assert_near(found, expected, 0.005)
        radii = [np.hypot(motion[100:, U], motion[100:, V]) / motion[100:, R] for motion in (found, expected)]
        assert radii[0] == pytest.approx(radii[1], rel=1e-3)
    assert right[0][-1, PSI] > 0.0 and right[0][100, PHI] > 0.0
    assert left[0] == pytest.approx(right[0] * np.tile([1, -1], 6), abs=1e-9)


@pytest.mark.parametrize("degrees", [4.0, -4.0], ids=["down", "up"])
def test_remus_dives_as_published(tmp_path: Path, degrees: float) -> None:
    """Stern planes 4 deg off level flight for 6 s change pitch, heave and depth as published to 0.2 %.

    Positive planes bring the bow down. Tolerance: the three digits of Prestero's sums make 0.09 % of depth.
    """
    phases = [(1.0, (THRUST, 0.0, LEVEL)), (6.0, (THRUST, 0.0, LEVEL + math.radians(degrees)))]
    found, expected = both_remus(tmp_path, phases, FASTEST)
    assert_near(found, expected, 2e-3)
    assert degrees * (found[-1, THETA] - found[10, THETA]) < 0.0


def test_remus_sets_out_as_published(tmp_path: Path) -> None:
    """Its propeller alone, from rest: 7 N lift it, its nose dips, it dives; to 0.1 % for 40 s."""
    found, expected = both_remus(tmp_path, [(40.0, (THRUST, 0.0, 0.0))], 0.0)
    assert_near(found, expected, 1e-3)
    assert found[:, Z].min() < -0.5 and found[-1, Z] > 3.0


Z_B, ROV_BUOYANCY = -0.01, 1000 * 9.82 * 0.0134  # m, N
SINKS = 13.5 * 9.82 - ROV_BUOYANCY  # N
INERTIA = np.add([13.5, 13.5, 13.5, 0.26, 0.23, 0.37], [6.36, 7.12, 18.68, 0.189, 0.135, 0.222])
LINEAR, QUADRATIC = np.array([13.7, 0, 33.0, 0, 0.8, 0]), np.array([141, 217, 190, 1.19, 0.47, 1.5])
SIDES = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])  # front right, front left, rear right, rear left
PLACES = np.array([*((0.156 * x, 0.111 * y, 0.085) for x, y in SIDES), *((0.12 * x, 0.218 * y, 0) for x, y in SIDES)])
PUSHES = np.zeros((8, 3))
PUSHES[:4, :2] = math.sqrt(0.5) * np.array([[1, -1], [1, 1], [-1, -1], [-1, 1]])
PUSHES[4:, 2] = -1, 1, 1, -1
ALLOCATION = np.vstack([PUSHES.T, np.cross(PLACES, PUSHES).T])
SENSE = np.array([1, 1, -1, -1, 1, -1, -1, 1])  # thrusters of the platform all push ahead or up


def rov(_: float, state: Any, voltages: Sequence[float]) -> list[float]:
    """M nu_dot + C(nu) nu + D(nu) nu + g(eta) = tau of von Benzon et al., with M and D diagonal; voltages -1..1."""
    u, v, w, p, q, r = nu = state[:6]
    x, y, z, k, m, n = INERTIA
    (s1, s2), (c1, c2) = np.sin(state[PHI:PSI]), np.cos(state[PHI:PSI])
    turning = [
        z * w * q - y * v * r, x * u * r - z * w * p, y * v * p - x * u * q,
        (z - y) * v * w + (n - m) * q * r, (x - z) * u * w + (k - n) * p * r, (y - x) * u * v + (m - k) * p * q,
    ]  # fmt: skip
    damping, lever = (LINEAR + QUADRATIC * np.abs(nu)) * nu, Z_B * ROV_BUOYANCY
    restoring = [SINKS * s2, -SINKS * c2 * s1, -SINKS * c2 * c1, -lever * c2 * s1, -lever * s2, 0.0]
    thrust = 80.0 / (1.0 + np.exp(-4.0 * np.power(voltages, 3))) - 40.0
    return with_kinematics(state, (ALLOCATION @ thrust - turning - damping - restoring) / INERTIA)


def voltages_for(wrench: Sequence[float]) -> Any:
    """The published thrusters' voltages that give a force and moment together (6,) [N, N m], and carry the weight."""
    thrust = np.linalg.pinv(ALLOCATION) @ (np.array(wrench) - [0.0, 0.0, SINKS, 0.0, 0.0, 0.0])
    return np.cbrt(np.log((40.0 + thrust) / (40.0 - thrust)) / 4.0)


def both_rov(folder: Path, phases: Phases) -> tuple[Any, Any]:
    """Found and expected motion under voltages of the published thrusters."""
    found = swum(folder, "bluerov2_heavy", [(seconds, SENSE * voltages) for seconds, voltages in phases])
    return found, integrated(rov, phases)


def steady(force: float, axis: int) -> float:
    """The speed at which D + Q |speed| balances a force along one axis."""
    return float(np.roots([QUADRATIC[axis], LINEAR[axis], -force]).max())


def test_rov_runs_ahead_and_coasts_as_published(tmp_path: Path) -> None:
    """27.7 N ahead (V = 0.5), then none: steady speed and decay have closed forms, which are met to 0.1 %.

    13.7 u + 141 u^2 = 27.7 N. Decay from u_0 with a = 13.7 kg/s, b = 141 kg/m and m = 19.86 kg, of which 6.36 kg added
    mass: u = a e u_0 / (a + b u_0 (1 - e)), e = exp(-a t / m). Tolerance: the thrusters' table is straight between
    points, which leaves 0.05 N of the verticals and 0.3 deg of pitch.
    """
    found, expected = both_rov(tmp_path, [(5.0, voltages_for([27.7, 0, 0, 0, 0, 0])), (6.0, voltages_for([0.0] * 6))])
    fastest, left = steady(27.7, U), np.exp(-13.7 * np.arange(61) * TICK / 19.86)
    coasting = 13.7 * left * fastest / (13.7 + 141.0 * fastest * (1.0 - left))
    assert found[50:, U] == pytest.approx(coasting, abs=1e-3 * fastest)
    assert_near(found, expected, 1e-3, [U, X])


def test_rov_turns_on_the_spot_as_published(tmp_path: Path) -> None:
    """3.85 N m give r = r_0 tanh(1.5 r_0 t / 0.592 kg m^2), 1.5 r_0^2 = 3.85 N m, to 0.1 %, and it stays in place."""
    found, expected = both_rov(tmp_path, [(6.0, voltages_for([0, 0, 0, 0, 0, 3.85]))])
    fastest = steady(3.85, R)
    assert found[:, R] == pytest.approx(fastest * np.tanh(1.5 * fastest * np.arange(61) * TICK / 0.592), rel=1e-3)
    assert_near(found, expected, 1e-3, [R, PSI])
    assert np.abs(found[:, [X, Y]]).max() < 1e-9


@pytest.mark.parametrize("force", [-20.0, 20.0], ids=["rises", "dives"])
def test_rov_moves_up_and_down_as_published(tmp_path: Path, force: float) -> None:
    """20 N beside what carries its weight end in 33 w + 190 w^2 to 1 %: thrusters are up to 0.08 N off their curve."""
    found, expected = both_rov(tmp_path, [(8.0, voltages_for([0, 0, force, 0, 0, 0]))])
    assert found[-1, W] == pytest.approx(math.copysign(steady(20.0, W), force), rel=0.01)
    assert_near(found, expected, 0.01, [W, Z])


NOSE_UP = (0.3, 0.3, -0.3, -0.3, 0.0, 0.0, 0.0, 0.0)
ALL_AXES = (0.3, 0.5, -0.45, -0.4, -0.25, -0.25, -0.35, 0.45)
OTHERWISE = (0.55, 0.35, -0.4, -0.55, -0.4, 0.45, -0.35, -0.15)


@pytest.mark.parametrize("voltages", [NOSE_UP, ALL_AXES, OTHERWISE], ids=["nose_up", "all_axes", "otherwise"])
def test_rov_tumbles_as_published(tmp_path: Path, voltages: Sequence[float]) -> None:
    """Thrusters that pitch it by 28 deg, or push and turn it about all axes, move it as published to 0.1 % for 12 s.

    Voltages are points of the thrusters' table, which has four digits.
    """
    found, expected = both_rov(tmp_path, [(12.0, np.array(voltages))])
    assert np.abs(expected[:, THETA]).max() > 0.4
    assert_near(found, expected, 1e-3)
