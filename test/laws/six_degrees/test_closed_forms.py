"""Motions in six degrees of freedom whose closed forms are known: pendulum, Munk, terminal speed, current, fins."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

Make = Callable[..., Any]


@pytest.fixture(scope="module")
def plain() -> Any:
    """A neutral vehicle of 10 kg whose weight is 5 cm below its buoyancy, with diagonal matrices."""
    from cocorosim_ros.world.six_degrees.vehicle import Vehicle

    return Vehicle(
        mass=10.0, inertia=np.diag([0.3, 0.5, 0.6]), added_mass=np.diag([3.0, 8.0, 9.0, 0.1, 0.2, 0.25]),
        centre_of_buoyancy=np.array([0.0, 0.0, 0.05]), weight=98.1, buoyancy=98.1,
    )  # fmt: skip


def rate_of(vehicle: Any, row: Any, command: Any = ()) -> Any:
    """The derivative (13,) of a state, by compiled functions called from Python."""
    from cocorosim_ros.world.six_degrees.bodies import Body, build_bodies
    from cocorosim_ros.world.six_degrees.dynamics import state_rate
    from cocorosim_ros.world.six_degrees.stepping import set_effort

    numbers = build_bodies([vehicle])
    body = Body(*(getattr(numbers, name)[0] for name in Body._fields[:-1]), np.zeros(0))
    rate, effort = np.zeros(13), np.zeros(len(command))
    set_effort(np.array(command, dtype=np.float64), body, effort)
    state_rate(np.array(row), 0.0, effort, body, rate)
    return rate


@pytest.mark.parametrize(("axis", "inertia"), [("roll", 0.4), ("pitch", 0.7)])
def test_pendulum_about_the_metacentre(swim: Make, start: Make, plain: Any, axis: str, inertia: float) -> None:
    """Small angles swing as a pendulum of sqrt(B d / I): angle = a cos(omega t), to the square of the angle.

    The centre of gravity is the origin, and neither axis couples with others.
    """
    amplitude = 0.001
    states = swim(plain, start(**{axis: amplitude}), 10.0, 0.01)
    omega = math.sqrt(98.1 * 0.05 / inertia)
    angle = Rotation.from_quat(states[:, 3:7]).as_euler("xyz")[:, 0 if axis == "roll" else 1]
    assert np.abs(angle - amplitude * np.cos(omega * np.arange(len(states)) * 0.01)).max() < 10 * amplitude**3


def test_large_swing_has_the_period_of_the_elliptic_integral(swim: Make, start: Make, plain: Any) -> None:
    """A roll of 90 deg swings with the period 4 K(sin^2(45 deg)) / omega."""
    from scipy.special import ellipk

    states = swim(plain, start(roll=math.pi / 2), 12.0, 0.005)
    rate = states[:, 10]
    turn = np.flatnonzero((rate[:-1] < 0.0) & (rate[1:] >= 0.0))  # half a period
    crossing = (turn[0] - rate[turn[0]] / (rate[turn[0] + 1] - rate[turn[0]])) * 0.005
    assert 2 * crossing == pytest.approx(4 * ellipk(0.5) / math.sqrt(98.1 * 0.05 / 0.4), rel=1e-5)


def test_munk_moment_turns_a_drifting_hull(start: Make, plain: Any) -> None:
    """At u and v without turning N = (X_added - Y_added) u v: added masses of 3 and 8 kg turn it broadside."""
    rate = rate_of(plain, start([1.2, 0.3, 0, 0, 0, 0]))
    assert rate[12] == pytest.approx((3.0 - 8.0) * 1.2 * 0.3 / (0.6 + 0.25), rel=1e-14)
    assert rate[7:12] == pytest.approx(np.zeros(5), abs=1e-15)


def test_weight_aside_of_the_origin_acts_as_a_lever(start: Make, plain: Any) -> None:
    """A weight 2 cm ahead of the buoyancy pulls the bow down, about +y, as W d does; mass and inertia are coupled."""
    ahead = replace(plain, centre_of_gravity=np.array([0.02, 0.0, 0.0]), centre_of_buoyancy=np.zeros(3))
    rate = rate_of(ahead, start())
    # 19 w_dot - 10 * 0.02 q_dot = 0; (0.5 + 0.2 + 10 * 0.02^2) q_dot - 0.2 w_dot = 98.1 * 0.02, by hand.
    pitch = 98.1 * 0.02 / (0.7 + 10 * 0.02**2 - 0.2 * 0.2 / 19.0)
    assert rate[11] == pytest.approx(pitch, rel=1e-12)
    assert rate[9] == pytest.approx(0.2 * pitch / 19.0, rel=1e-12)


def test_terminal_speeds(swim: Make, start: Make, plain: Any) -> None:
    """Ahead F = d u + k u^2, upwards by 1 N of buoyancy the same, and a turn by its torque."""
    vehicle = replace(
        plain, linear=np.diag([4.0, 5, 6, 1, 1, 0.5]), quadratic=np.diag([20.0, 30, 40, 1, 1, 2.0]),
        wrench=np.array([[1.0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1.0]]), limit=np.array([[12.0, 8.0], [3.0, 3.0]]),
    )  # fmt: skip

    def speed(force: float, linear: float, quadratic: float) -> float:
        return (math.sqrt(linear**2 + 4 * quadratic * force) - linear) / (2 * quadratic)

    def end(moved: Any, command: Any) -> Any:
        return swim(moved, start(), 60.0, 0.02, command)[-1, 7:]

    assert end(vehicle, [0.5, 0.0])[0] == pytest.approx(speed(6.0, 4, 20), rel=1e-9)
    assert end(vehicle, [-1.0, 0.0])[0] == pytest.approx(-speed(8.0, 4, 20), rel=1e-9)
    assert end(vehicle, [0.0, 2.0])[5] == pytest.approx(speed(3.0, 0.5, 2.0), rel=1e-9)  # twice the most is the most
    assert end(vehicle, [math.nan, 0.0]) == pytest.approx(np.zeros(6), abs=0.0)
    assert end(replace(vehicle, buoyancy=99.1), [0.0, 0.0])[2] == pytest.approx(speed(1.0, 6, 40), rel=1e-9)


def test_coupled_drift_and_turn_die_out_by_the_matrix_exponential(swim: Make, start: Make, plain: Any) -> None:
    """Small v and r with Y_r and N_v follow exp(-M^-1 D t), to the cube of their size: Coriolis forces move u alone."""
    from scipy.linalg import expm

    linear = np.diag([4.0, 9.0, 6.0, 1.0, 1.0, 0.8])
    linear[1, 5], linear[5, 1] = 1.9, -1.2  # -Y_r, -N_v
    vehicle, size = replace(plain, linear=linear), 1e-3
    states = swim(vehicle, start([0.0, size, 0.0, 0.0, 0.0, -2.0 * size]), 4.0, 0.01)
    both = np.ix_([1, 5], [1, 5])
    rate = -np.linalg.solve(np.diag([18.0, 0.85]), linear[both])  # 10 + 8 kg, 0.6 + 0.25 kg m^2
    expected = np.array([expm(rate * index * 0.01) @ [size, -2.0 * size] for index in range(len(states))])
    assert np.abs(states[:, [8, 12]] - expected).max() < 10.0 * size**3
    alone = swim(replace(plain, linear=np.diag(np.diag(linear))), states[0], 4.0, 0.01)
    assert np.abs(states[:, [8, 12]] - alone[:, [8, 12]]).max() > 0.1 * size  # the couplings do matter


def test_uniform_current_is_still_water_seen_from_a_drifting_frame(swim: Make, start: Make, lopsided: Any) -> None:
    """In a current V the vehicle moves as in still water from the velocity nu - R^T V, plus V t."""
    from cocorosim_ros.world.water.flow import CurrentAtWork, make_flow

    damped = replace(lopsided, linear=np.diag([2.0, 3, 4, 1, 1, 1]), quadratic=np.diag([5.0, 6, 7, 1, 2, 3]))
    water = np.array([0.3, -0.2, 0.0])
    flow = make_flow([CurrentAtWork("uniform", water[:2])])
    row = start([0.5, 0.2, -0.1, 0.4, 0.3, -0.6], 0.3, -0.2, 1.1)
    turned = Rotation.from_quat(row[3:7])
    still = row.copy()
    still[7:10] -= turned.inv().apply(water)
    there, here = swim(damped, row, 10.0, 0.01, flow=flow)[-1], swim(damped, still, 10.0, 0.01)[-1]
    assert there[:3] == pytest.approx(here[:3] + 10.0 * water, abs=1e-7)
    assert there[3:7] == pytest.approx(here[3:7], abs=1e-7)
    assert there[7:10] == pytest.approx(here[7:10] + Rotation.from_quat(here[3:7]).inv().apply(water), abs=1e-7)


def test_turning_the_world_turns_the_motion(swim: Make, start: Make, lopsided: Any) -> None:
    """A start turned about the vertical leads to the end turned by the same."""
    vehicle = replace(lopsided, linear=np.diag([2.0, 3, 4, 1, 1, 1]))
    velocity = [0.5, 0.2, -0.1, 0.4, 0.3, -0.6]
    first, turned = (swim(vehicle, start(velocity, 0.3, -0.2, yaw), 8.0, 0.01)[-1] for yaw in (0.4, 1.7))
    by = Rotation.from_euler("z", 1.3)
    assert by.apply(first[:3]) == pytest.approx(turned[:3], abs=1e-8)
    assert np.abs((by * Rotation.from_quat(first[3:7])).inv().as_matrix()
                  @ Rotation.from_quat(turned[3:7]).as_matrix() - np.eye(3)).max() < 1e-8  # fmt: skip
    assert first[7:] == pytest.approx(turned[7:], abs=1e-8)


def test_mirrored_vehicle_moves_mirrored(swim: Make, start: Make, plain: Any) -> None:
    """A vehicle that is its own mirror image left to right, started mirrored, ends mirrored."""
    vehicle = replace(plain, linear=np.diag([2.0, 3, 4, 1, 1, 1]), centre_of_gravity=np.array([-0.03, 0.0, -0.02]))
    velocity = np.array([0.5, 0.2, -0.1, 0.4, 0.3, -0.6])
    mirror = np.array([1, -1, 1, -1, 1, -1])
    first = swim(vehicle, start(velocity, 0.3, -0.2, 0.7), 8.0, 0.01)[-1]
    other = swim(vehicle, start(velocity * mirror, -0.3, -0.2, -0.7), 8.0, 0.01)[-1]
    assert other[:3] == pytest.approx(first[:3] * mirror[:3], abs=1e-12)
    assert other[3:7] == pytest.approx(first[3:7] * [-1, 1, -1, 1], abs=1e-12)
    assert other[7:] == pytest.approx(first[7:] * mirror, abs=1e-12)


def test_fin_lifts_by_its_angle_of_attack(start: Make, plain: Any) -> None:
    """A stern plane at 5 deg and 2 m/s gives rho S c u^2 angle / 2 at its lever; in a sideslip it gives way."""
    from cocorosim_ros.world.six_degrees.vehicle import Fin

    neutral = replace(plain, added_mass=np.zeros((6, 6)))
    plane = Fin(place=(-0.7, 0.0, 0.0), normal=(0.0, 1.0, 0.0), area=0.01, slope=3.0)
    limit = np.full((1, 2), math.radians(10.0))
    vehicle = replace(neutral, fins={0: plane}, wrench=np.zeros((1, 6)), limit=limit)
    lift = 0.5 * 1000.0 * 0.01 * 3.0 * 4.0 * math.radians(5.0)
    rate = rate_of(vehicle, start([2.0, 0, 0, 0, 0, 0]), [0.5])
    assert rate[8] == pytest.approx(lift / 10.0, rel=1e-13)
    assert rate[12] == pytest.approx(-0.7 * lift / 0.6, rel=1e-13)
    rate = rate_of(vehicle, start([2.0, 0.1, 0, 0, 0, 0]), [0.0])
    slip = -0.5 * 1000.0 * 0.01 * 3.0 * 2.0 * 0.1
    assert rate[8] == pytest.approx(slip / 10.0, rel=1e-13)
    assert rate[12] == pytest.approx(-0.7 * slip / 0.6, rel=1e-13)  # a weathercock: it turns the bow into the slip
    rate = rate_of(vehicle, start([2.0, 0, 0, 0, 0, 0.2]), [0.0])
    assert rate[12] == pytest.approx(-0.5 * 1000.0 * 0.01 * 3.0 * 2.0 * 0.7**2 * 0.2 / 0.6, rel=1e-13)


def test_angles_and_quaternions_are_those_of_scipy() -> None:
    """Roll, pitch and yaw about fixed axes, both ways."""
    from cocorosim_ros.world.six_degrees.attitude import angles_of, attitude_of

    draw = np.random.default_rng(2)
    for _ in range(20):
        angles = draw.uniform([-3.1, -1.5, -3.1], [3.1, 1.5, 3.1])
        expected = Rotation.from_euler("xyz", angles)
        ours = attitude_of(*angles)
        assert np.abs(Rotation.from_quat(ours).as_matrix() - expected.as_matrix()).max() < 1e-15
        assert np.column_stack(angles_of(ours[None]))[0] == pytest.approx(angles, abs=1e-12)


def test_mass_matrix_that_could_not_be_is_refused(plain: Any) -> None:
    """One sentence for an added mass that is not symmetric, and for one of the wrong sign."""
    from cocorosim_ros.foundation.errors import CocorosimError
    from cocorosim_ros.world.six_degrees.bodies import build_bodies

    crooked = np.diag([3.0, 8.0, 9.0, 0.1, 0.2, 0.25])
    crooked[1, 5] = 1.0
    with pytest.raises(CocorosimError, match="not symmetric"):
        build_bodies([replace(plain, added_mass=crooked)])
    with pytest.raises(CocorosimError, match="eigenvalue"):
        build_bodies([replace(plain, added_mass=-20.0 * np.eye(6))])
