"""Without damping a vehicle in six degrees of freedom keeps its energy, and in still water its momentum."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

Make = Callable[..., Any]


def energy(states: Any, vehicle: Any) -> Any:
    """Kinetic and potential energy [J] of rows: nu M nu / 2 + (W - B) z + k . (W r_g - B r_b), k in body axes."""
    velocity, turned = states[:, 7:], Rotation.from_quat(states[:, 3:7])
    moment = vehicle.weight * vehicle.centre_of_gravity - vehicle.buoyancy * vehicle.centre_of_buoyancy
    kinetic = 0.5 * np.einsum("ti,ij,tj->t", velocity, vehicle.mass_matrix(), velocity)
    potential = (vehicle.weight - vehicle.buoyancy) * states[:, 2] + turned.apply(moment)[:, 2]
    return kinetic + potential


def test_energy_is_kept_to_the_order_of_the_step(swim: Make, start: Make, lopsided: Any) -> None:
    """Tumbling for 10 s: the error falls about 16-fold or more with each halved step, as fourth order has it."""
    row = start([0.8, -0.3, 0.2, 0.9, -1.2, 0.7], 0.4, 0.3, 1.0)
    errors = []
    for step in (0.04, 0.02, 0.01):
        of_time = energy(swim(lopsided, row, 10.0, step), lopsided)
        errors.append(np.abs(of_time - of_time[0]).max())
    assert errors[0] < 0.1
    assert errors[0] / errors[1] > 12.0
    assert errors[1] / errors[2] > 12.0


def test_momentum_of_neutral_vehicle_is_kept_in_the_world(swim: Make, start: Make, lopsided: Any) -> None:
    """Without weight and buoyancy R a and R b + x x (R a), with M nu = (a, b), stay as they are (Kirchhoff 1869)."""
    from dataclasses import replace

    states = swim(replace(lopsided, weight=0.0, buoyancy=0.0), start([0.8, -0.3, 0.2, 0.9, -1.2, 0.7]), 5.0, 0.005)
    momentum, turned = states[:, 7:] @ lopsided.mass_matrix(), Rotation.from_quat(states[:, 3:7])
    linear = turned.apply(momentum[:, :3])
    angular = turned.apply(momentum[:, 3:]) + np.cross(states[:, :3] - states[0, :3], linear)
    assert np.abs(states[:, 10:] - states[0, 10:]).max() > 0.5  # it does tumble
    assert np.abs(linear - linear[0]).max() < 1e-7
    assert np.abs(angular - angular[0]).max() < 1e-7


def test_free_top_turns_by_jacobi_functions(swim: Make, start: Make) -> None:
    """A free rigid body: p, q, r = A cn, -B sn, C dn of Jacobi (Landau and Lifshitz, Mechanics, section 37)."""
    from scipy.special import ellipj

    from cocorosim_ros.world.six_degrees.vehicle import Vehicle

    first, second, third = 1.0, 2.0, 3.0  # kg m^2
    p, r = 0.5, 1.0  # rad/s, with no pitch rate at the start
    twice, square = first * p**2 + third * r**2, (first * p) ** 2 + (third * r) ** 2  # 2 E and L^2
    assert square > twice * second  # so that r never changes its sign
    pace = np.sqrt((third - second) * (square - twice * first) / (first * second * third))
    modulus = (second - first) * (twice * third - square) / ((third - second) * (square - twice * first))
    states = swim(Vehicle(1.0, np.diag([first, second, third])), start([0, 0, 0, p, 0, r]), 30.0, 0.01)
    sn, cn, dn, _ = ellipj(pace * np.arange(len(states)) * 0.01, modulus)
    height = np.sqrt((twice * third - square) / (second * (third - second)))
    expected = np.column_stack([p * cn, height * sn, r * dn])
    sign = np.sign(states[1, 11])  # the equations fix it: I2 q_dot = (I3 - I1) r p > 0
    assert sign == np.sign((third - first) * r * p)
    assert np.abs(states[:, 10:] - expected).max() < 1e-7


def test_precession_of_symmetric_top(swim: Make, start: Make) -> None:
    """A body with two equal moments nutates at (I3 - I1) r / I1 in its own axes."""
    from cocorosim_ros.world.six_degrees.vehicle import Vehicle

    states = swim(Vehicle(1.0, np.diag([1.0, 1.0, 1.6])), start([0, 0, 0, 0.2, 0, 1.5]), 20.0, 0.01)
    phase = 0.6 * 1.5 * np.arange(len(states)) * 0.01
    expected = np.column_stack([0.2 * np.cos(phase), 0.2 * np.sin(phase), np.full(len(states), 1.5)])
    assert np.abs(states[:, 10:] - expected).max() < 1e-8


def test_coriolis_forces_do_no_work() -> None:
    """x C y = -y C x for every momentum and any two velocities: C is skew-symmetric (Fossen 2011, property 6.2)."""
    from cocorosim_ros.world.six_degrees.dynamics import add_coriolis

    draw = np.random.default_rng(5)
    for _ in range(50):
        momentum, first, second = draw.normal(size=(3, 6))
        forth, back = np.zeros(6), np.zeros(6)
        add_coriolis(momentum, first, forth)
        add_coriolis(momentum, second, back)
        assert second @ forth == pytest.approx(-(first @ back), abs=1e-13)


def test_damping_never_adds_energy(swim: Make, start: Make, lopsided: Any) -> None:
    """With positive damping the energy falls in every step, whatever the motion."""
    from dataclasses import replace

    damped = replace(lopsided, linear=np.diag([2.0, 3, 4, 0.1, 0.2, 0.3]), quadratic=np.diag([5.0, 6, 7, 1, 2, 3]))
    of_time = energy(swim(damped, start([1.0, -0.5, 0.3, 1.0, 2.0, -1.0], 0.5, -0.4), 20.0, 0.01), lopsided)
    assert (np.diff(of_time) < 0.0).all()


def test_coupled_linear_damping_never_adds_energy(swim: Make, start: Make, lopsided: Any) -> None:
    """The energy falls in every step with a full damping matrix whose symmetric part is positive definite.

    Its antisymmetric part, ten times as large, moves energy between the axes and takes none.
    """
    from dataclasses import replace

    from cocorosim_ros.world.six_degrees.vehicle import check_dissipation

    draw = np.random.default_rng(7)
    root, other = draw.normal(size=(2, 6, 6))
    damped = replace(lopsided, linear=0.2 * root @ root.T + 0.1 * np.eye(6) + (other - other.T))
    check_dissipation(damped)
    of_time = energy(swim(damped, start([1.0, -0.5, 0.3, 1.0, 2.0, -1.0], 0.5, -0.4), 20.0, 0.01), lopsided)
    assert (np.diff(of_time) < 0.0).all()


def test_damping_that_gives_energy_is_told_and_does(swim: Make, start: Make, lopsided: Any) -> None:
    """With (Y_r + N_v)^2 beyond 4 Y_v N_r a motion gains energy, and the sentence says so; at the limit none does."""
    from dataclasses import replace

    from cocorosim_ros.foundation.errors import CocorosimError
    from cocorosim_ros.world.six_degrees.vehicle import check_dissipation

    linear = np.diag([2.0, 4.0, 4.0, 1.0, 1.0, 1.0])
    linear[1, 5], linear[5, 1] = -3.0, -1.0
    check_dissipation(replace(lopsided, linear=linear))  # (3 + 1)^2 = 4 * 4 * 1
    linear[1, 5] = -3.1
    giving = replace(lopsided, linear=linear)
    with pytest.raises(CocorosimError, match=r"gives energy at some motion.* eigenvalue -0\.0"):
        check_dissipation(giving)
    best = np.linalg.eigh(0.5 * (linear + linear.T))[1][:, 0]
    of_time = energy(swim(giving, start(best), 0.01, 0.001), lopsided)
    assert of_time[-1] > of_time[0]


def test_attitude_stays_of_unit_length(swim: Make, start: Make, lopsided: Any) -> None:
    """Thousands of coarse steps leave no error of the quaternion's length beyond rounding."""
    states = swim(lopsided, start([0, 0, 0, 1.0, 2.0, 0.5]), 200.0, 0.05)
    assert np.abs(np.linalg.norm(states[:, 3:7], axis=1) - 1.0).max() < 4e-16
