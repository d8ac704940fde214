"""The Concealer's physics obeys closed forms, and every hidden number acts where it should and nowhere else."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

Run = Callable[..., Any]
MASS, INERTIA, DRAG, YAW_DRAG, LEVER = 0.44, 4.05e-4, 1.7778, 1.14e-4, 0.055 * math.cos(math.radians(63.0))
PUMP = 0.0981  # N


def test_straight_ahead_is_the_logarithm_of_a_hyperbolic_cosine(run: Run) -> None:
    """x(t) = (m/k) ln cosh(v k t / m) from rest under constant thrust."""
    rows = run((1.0, 1.0, 0.0), 20.0)
    speed = math.sqrt(0.01 / DRAG)
    time = np.arange(len(rows)) * 0.02
    assert np.allclose(rows[:, 0], MASS / DRAG * np.log(np.cosh(speed * DRAG * time / MASS)), atol=1e-6)
    assert rows[-1, 4] == pytest.approx(speed * math.tanh(speed * DRAG * 20.0 / MASS), rel=1e-6)


def test_turning_ends_at_the_terminal_rate(run: Run) -> None:
    """r = sqrt(N / Cr), counter-clockwise when the right thruster pushes forward."""
    rows = run((-1.0, 1.0, 0.0), 30.0)
    assert rows[-1, 7] == pytest.approx(math.sqrt(0.01 * LEVER / YAW_DRAG), rel=1e-6)
    rate = np.sqrt(0.01 * LEVER / YAW_DRAG)
    assert rows[100, 7] == pytest.approx(rate * math.tanh(rate * YAW_DRAG * 2.0 / INERTIA), rel=1e-4)


def test_a_full_pump_rises_at_the_terminal_speed(run: Run) -> None:
    """w = sqrt(pump / k), and the other way with the pump empty."""
    for command in (1.0, -1.0):
        speed = run((0.0, 0.0, command), 20.0)[-1, 6]
        assert speed == pytest.approx(command * math.sqrt(PUMP / DRAG), rel=1e-6)


def test_motion_without_forces_keeps_its_direction_in_the_world(run: Run) -> None:
    """A turning robot that drifts without drag moves straight on."""
    rows = run((0.0, 0.0, 0.0), 10.0, {4: 0.05, 5: 0.02, 7: 1.0}, drag=0.0, yaw_drag=0.0)
    time = np.arange(len(rows)) * 0.02
    assert np.allclose(rows[:, 0], 0.05 * time, atol=1e-5)
    assert np.allclose(rows[:, 1], 0.02 * time, atol=1e-5)
    assert np.allclose(rows[:, 16:19], 0.0, atol=1e-12)  # an accelerometer feels nothing


def test_a_robot_drifts_with_a_current(run: Run) -> None:
    """At rest in the water its speed is the water's, and it feels no force; added mass changes nothing."""
    start = {4: 0.01, 5: 0.0}
    for added in (0.0, 0.1):
        rows = run((0.0, 0.0, 0.0), 10.0, start, current_x=0.01, added_sway=added, added_surge=0.5 * added)
        assert np.allclose(rows[:, 0], 0.01 * np.arange(len(rows)) * 0.02, atol=1e-9)
    turning = run((0.0, 0.0, 0.0), 10.0, start | {7: 1.0}, current_x=0.01, added_sway=0.1, added_surge=0.05)
    assert np.allclose(turning[:, 1], 0.0, atol=1e-5)


def test_added_mass_keeps_energy_and_momentum_of_a_free_body(run: Run) -> None:
    """Kirchhoff's equations without drag: T = (M_u u^2 + M_v v^2 + I r^2)/2 and the world momentum stay."""
    start = {4: 0.05, 5: 0.03, 7: 0.8}
    rows = run((0.0, 0.0, 0.0), 20.0, start, drag=0.0, yaw_drag=0.0, added_surge=0.05, added_sway=0.2, added_yaw=1e-4)
    u, v, r, yaw = rows[:, 4], rows[:, 5], rows[:, 7], rows[:, 3]
    energy = 0.49 * u**2 + 0.64 * v**2 + 5.05e-4 * r**2
    assert np.allclose(energy, energy[0], rtol=1e-5)
    east = 0.49 * u * np.cos(yaw) - 0.64 * v * np.sin(yaw)
    assert np.allclose(east, east[0], atol=1e-5 * abs(energy).max() + 1e-6)


def test_an_offset_body_turns_about_its_centre_of_mass(run: Run) -> None:
    """Without drag the centre goes straight at its speed of the start, and the turn rate stays.

    The midpoint rule turns velocities by h^2 r^3 / 6 too slowly: 4e-5 rad in 20 s, on 1 m of way.
    """
    ahead, left = 0.012, -0.004
    start = {4: 0.05, 5: 0.03, 7: 0.8}
    rows = run((0.0, 0.0, 0.0), 20.0, start, drag=0.0, yaw_drag=0.0, centre_ahead=ahead, centre_left=left)
    yaw, time = rows[:, 3], 0.02 * np.arange(len(rows))
    east = rows[:, 0] + ahead * np.cos(yaw) - left * np.sin(yaw)
    north = rows[:, 1] + ahead * np.sin(yaw) + left * np.cos(yaw)
    assert np.allclose(rows[:, 7], 0.8, rtol=1e-6)
    assert np.allclose(east - ahead, (0.05 - left * 0.8) * time, atol=5e-5)
    assert np.allclose(north - left, (0.03 + ahead * 0.8) * time, atol=5e-5)


def test_water_in_the_pump_moves_the_centre_of_mass(run: Run) -> None:
    """On the spot a moment alone acts on the inertia about the centre, and the origin goes round it."""
    rows = run((-0.2, 0.2, 1.0), 2.0, drag=0.0, yaw_drag=0.0, centre_ahead=0.01, centre_shift=1e-3)
    assert np.allclose(rows[:, 7], 0.2 * 0.01 * LEVER / INERTIA * 0.02 * np.arange(len(rows)), rtol=1e-3, atol=0.05)
    assert np.allclose(rows[:, 0], 0.011 - 0.011 * np.cos(rows[:, 3]), atol=1e-4)


@pytest.mark.parametrize(
    ("places", "command", "start", "channel", "expected"),
    [
        ({"linear_surge": 0.1}, (0, 0, 0), {4: 1e-6}, 4, -0.1 * 1e-6 / MASS),
        ({"linear_yaw": 1e-3}, (0, 0, 0), {7: 1e-6}, 7, -1e-3 * 1e-6 / INERTIA),
        ({"cross_sway": 2.0, "strip_length": 0.08}, (0, 0, 0), {5: 0.05}, 5, -3.0 * DRAG * 0.05**2 / MASS),
        ({"cross_heave": 0.5}, (0, 0, 0), {6: 0.05}, 6, -1.5 * DRAG * 0.05**2 / MASS),
        ({"asymmetry": 0.1}, (1, 1, 0), {}, 7, 0.1 * 0.005 * LEVER / INERTIA),
        ({"torque_bias": 1e-5}, (0, 0, 0), {}, 7, 1e-5 / INERTIA),
        ({"reverse_loss": 0.2}, (-1, -1, 0), {}, 4, -0.8 * 0.01 / MASS),
        ({"advance": 2.0}, (1, 1, 0), {4: 0.05}, 4, (0.9 * 0.01 - DRAG * 0.05**2) / MASS),
        ({"advance": 2.0}, (-1, -1, 0), {4: -0.05}, 4, (-0.9 * 0.01 + DRAG * 0.05**2) / MASS),
        ({"crashback": 4.0, "crashback_peak": 0.1}, (-1, -1, 0), {4: 0.05}, 4, (-0.84 * 0.01 - DRAG * 0.05**2) / MASS),
        ({"crashback": 4.0, "crashback_peak": 0.1}, (1, 1, 0), {4: -0.05}, 4, (0.84 * 0.01 + DRAG * 0.05**2) / MASS),
        ({"crashback": 4.0, "crashback_peak": 0.1}, (1, 1, 0), {4: 0.05}, 4, (0.01 - DRAG * 0.05**2) / MASS),
        ({"misalignment": 0.1}, (1, 1, 0), {}, 5, 0.01 * math.sin(0.1) / MASS),
        ({"dead_jump": 0.1}, (0.2, 0.2, 0), {}, 4, 0.2 * 0.01 / MASS),
        ({"dead_continuous": 0.1}, (0.2, 0.2, 0), {}, 4, 0.1 * 0.01 / MASS),
        ({"thrust_bend": 0.5}, (-0.2, -0.2, 0), {}, 4, -0.12 * 0.01 / MASS),
        ({"thrust_bend": 1.0, "dead_continuous": 0.1}, (0.6, 0.6, 0), {}, 4, 0.25 * 0.01 / MASS),
        ({"trim": 1e-3}, (0, 0, 0), {}, 6, 1e-3 / MASS),
        ({"shrink": 1e-3, "shrink_scale": 1e9}, (0, 0, 0), {}, 6, -1e-2 / MASS),
        ({"layer_force": 1e-3, "layer_depth": 5.0, "layer_width": 0.05}, (0, 0, 0), {}, 6, 1e-3 / MASS),
        ({"layer_force": 1e-3, "layer_depth": 15.0, "layer_width": 0.05}, (0, 0, 0), {}, 6, 0.0),
        ({"payload_force": 1e-3, "payload_time": -1.0, "payload_rise": 0.5}, (0, 0, 0), {}, 6, 1e-3 / MASS),
        ({"tether": 1e-3, "tether_x": 2.0, "tether_soft": 1e9}, (0, 0, 0), {0: 1.0}, 4, 1e-3 / MASS),
        ({"osc_y": 1e-3, "osc_phase": math.pi / 2}, (0, 0, 0), {}, 5, 1e-3 / MASS),
        ({"fin": 1e-2}, (0, 0, 0), {4: 0.05}, 7, 1e-2 * 0.05**2 / INERTIA),
        ({"vane": 1e-5}, (0, 0, 0), {3: math.pi / 2}, 7, 1e-5 / INERTIA),
        ({"friction_yaw": 1e-5, "friction_rate": 0.02}, (0, 0, 0), {7: 1.0}, 7, (-1e-5 - YAW_DRAG) / INERTIA),
        ({"torque_at_x": 1e-5}, (0, 0, 0), {0: 2.0}, 7, 2e-5 / INERTIA),
        ({"cubic": 5.0}, (0, 0, 0), {4: 0.1}, 4, -(5e-3 + DRAG * 0.01) / MASS),
        ({"power_three_halves": 0.1}, (0, 0, 0), {4: 0.04}, 4, -(0.1 * 0.008 + DRAG * 0.0016) / MASS),
        ({"lift": 0.2}, (0, 0, 0), {4: 0.1}, 6, 2e-3 / MASS),
        ({"roll_sway": 1e-3}, (0, 0, 0), {7: 1.0}, 5, 1e-3 / MASS),
        ({"pump_yaw": 1e-4}, (0, 0, 0.5), {}, 7, 5e-5 / INERTIA),
        ({"rate_surge": 1e-3}, (0, 0, 0.5), {}, 4, 1e-3 * 0.5 / 0.5 / MASS),
        ({"wind": 2.0}, (0, 0, 0), {}, 4, 0.7 * 0.005 * 0.5 * 1.225 * 2.0**2 / MASS),
        ({"wind": 2.0}, (0, 0, 0), {3: -math.pi / 2}, 5, 0.85 * 0.009 * 0.5 * 1.225 * 2.0**2 / MASS),
        ({"wind": 2.0, "wind_turn": 0.01}, (0, 0, 0), {3: -math.pi / 4}, 7, 9e-5 * 0.5 * 1.225 * 2.0**2 / INERTIA),
        ({"emerge": 0.1}, (0, 0, 0), {2: 0.0}, 6, -0.5 * 0.1 * 9.81),
        ({"emerge": 0.1}, (0, 0, 0), {2: -0.175}, 6, -5.0 / 32.0 * 0.1 * 9.81),
        ({"emerge": 0.1}, (0, 0, 0), {2: -0.35}, 6, 0.0),
        ({"wall_gain": 2.0, "half_x": 1.0, "wall_power": 3.0}, (0, 0, 0), {0: 1.0, 4: 0.1}, 4, -3 * DRAG * 0.01 / MASS),
    ],
)
def test_each_hidden_number_gives_its_acceleration(
    places: dict[str, float], command: Any, start: dict[int, float], channel: int, expected: float
) -> None:
    """The acceleration at one moment is what the law says, by hand."""
    from concealer import layout as at
    from concealer.physics import derivative

    p, s = at.nominal_robot(), np.zeros(at.STATE)
    p[at.FLOOR], p[at.HALF_X], p[at.HALF_Y] = -50.0, 100.0, 100.0
    for name, value in places.items():
        p[getattr(at, name.upper())] = value
    s[at.Z], s[at.PLAY] = -10.0, command[2]
    for place, value in start.items():
        s[place] = value
    rate = derivative(p, s, np.array(command, dtype=float), np.zeros(4), 0.0)
    assert rate[channel] == pytest.approx(expected, rel=1e-4, abs=1e-12)


def test_the_slope_of_a_crash_stop_is_that_of_the_speeds_against_the_thrust() -> None:
    """At one speed a against it s / (1 + (a / peak)^2), whatever the thrust; speeds along it do not count."""
    from concealer import layout as at
    from concealer.truth_after import AFTER

    p, rows, commands = at.nominal_robot(), np.zeros((50, at.ROW)), np.full((10, 3), -0.5)
    p[at.CRASHBACK], p[at.CRASHBACK_PEAK] = 3.0, 0.1
    rows[:25, at.U], rows[25:, at.U] = 0.05, -0.08
    commands[2] = -1.0
    assert AFTER["crashback_loss"](p, rows, commands) == {"slope": pytest.approx(3.0 / 1.25)}


def test_the_exponent_of_a_part_of_a_square_law_is_that_of_the_nearest_power() -> None:
    """Of the whole square law it is 2; commands at rest and at the limit say nothing: then it is as hidden."""
    from concealer import layout as at
    from concealer.truth_after import AFTER

    p, rows, commands = at.nominal_robot(), np.zeros((50, at.ROW)), np.zeros((10, 3))
    p[at.THRUST_BEND] = 1.0
    assert AFTER["thrust_curve"](p, rows, commands + 1.5) == {"exponent": 2.0}
    commands[:4, :2] = -0.3
    assert AFTER["thrust_curve"](p, rows, commands) == {"exponent": pytest.approx(2.0)}
    p[at.THRUST_BEND] = 0.5
    assert AFTER["thrust_curve"](p, rows, commands) == {"exponent": pytest.approx(math.log(0.195) / math.log(0.3))}


@pytest.mark.parametrize(("law", "name"), [("advance_loss", "ADVANCE"), ("crashback_loss", "CRASHBACK")])
def test_a_robot_that_is_never_driven_loses_what_is_hidden(law: str, name: str) -> None:
    """Adrift at 0.05 m/s without a command, and at rest under one: no speed counts, and the slope is that at rest."""
    from concealer import layout as at
    from concealer.truth_after import AFTER

    p, adrift, driven = at.nominal_robot(), np.zeros((50, at.ROW)), np.full((10, 3), -0.5)
    p[getattr(at, name)], p[at.CRASHBACK_PEAK] = 3.0, 0.1
    assert AFTER[law](p, adrift, driven) == {"slope": 3.0}
    adrift[:, at.U] = 0.05
    assert AFTER[law](p, adrift, np.zeros((10, 3))) == {"slope": 3.0}


ONLY = {  # which of u v w r a number may touch from rest under a command of both thrusters and the pump
    "asymmetry": "r", "torque_bias": "r", "trim": "w", "shrink": "w", "osc_z": "w", "osc_yaw": "r", "reverse_loss": "",
    "battery": "u", "linear_heave": "", "rate_heave": "w", "rate_yaw": "r", "pump_yaw": "r", "cross_sway": "",
    "pump_play": "w", "tether": "u", "osc_x": "u",
}  # fmt: skip


@pytest.mark.parametrize(("name", "channels"), ONLY.items())
def test_a_hidden_number_touches_only_its_channels(name: str, channels: str) -> None:
    """With and without it, only the named accelerations differ."""
    from concealer import layout as at
    from concealer.physics import derivative

    p, s = at.nominal_robot(), np.zeros(at.STATE)
    s[at.Z], s[at.PLAY], s[at.CHARGE] = -1.0, 0.2, 300.0
    p[[at.TETHER_X, at.OSC_PHASE]] = 1.0, 1.0
    command = np.array([0.5, 0.5, 0.2])
    without = derivative(p, s, command, np.zeros(4), 0.0)
    p[getattr(at, name.upper())] = 0.05
    if name == "pump_play":
        s[at.PLAY] -= 0.025
    changed = ~np.isclose(derivative(p, s, command, np.zeros(4), 0.0), without, rtol=1e-12, atol=1e-15)
    assert "".join(channel for channel, place in zip("uvwr", range(4, 8), strict=True) if changed[place]) == channels


def test_the_thruster_lag_delays_by_the_sum_of_its_stages(run: Run) -> None:
    """Behind a step, the momentum missing for ever is force times time constant (no drag)."""
    rows = run((1.0, 1.0, 0.0), 10.0, drag=0.0, lag_slow=0.25, lag_fast=0.05)
    assert rows[-1, 4] == pytest.approx(0.01 * (10.0 - 0.3) / MASS, rel=1e-4)


def test_the_backlash_holds_within_its_full_width(run: Run) -> None:
    """After a rise to 0.3 a fall by less than the width moves nothing; by more, it moves the rest."""
    command = np.repeat([[0, 0, 0.3], [0, 0, 0.25], [0, 0, 0.1]], 10, axis=0)
    rows = run(command, 3.0, pump_play=0.1)
    assert rows[45, 15] == pytest.approx(0.25)
    assert rows[95, 15] == pytest.approx(0.25)
    assert rows[-1, 15] == pytest.approx(0.15)


def test_a_wake_pushes_a_follower_by_its_gain_at_ten_centimetres() -> None:
    """0.1 m behind a robot at full thrust, the follower feels gain times thrust, backwards."""
    from concealer import layout as at
    from concealer.physics import wake

    p, s = np.tile(at.nominal_robot(), (2, 1)), np.zeros((2, at.STATE))
    p[:, at.WAKE] = 0.4
    s[0, [at.LEFT_SLOW, at.RIGHT_SLOW, at.YAW]] = 1.0, 1.0, math.pi / 2
    s[1, at.Y] = -0.1
    assert wake(p, s, 1) == pytest.approx([0.0, -0.004, 0.0], abs=1e-12)
    assert wake(p, s, 0) == pytest.approx([0.0, 0.0, 0.0])


def test_random_forces_have_the_matern_covariance() -> None:
    """Autocorrelation (1 + k t) exp(-k t) with k = 2/T, rms 1: smooth at zero, unlike an Ornstein-Uhlenbeck process."""
    from concealer.water import matern

    x = matern(np.random.default_rng(3), (4000, 400), 0.05, 2.0)
    assert x.std() == pytest.approx(1.0, abs=0.02)
    for lag in (1, 10, 40, 80):
        t = lag * 0.05
        assert np.mean(x[lag:] * x[:-lag]) == pytest.approx((1 + t) * math.exp(-t), abs=0.03)
    assert x[0].std() == pytest.approx(1.0, abs=0.12)
    assert x[1].std() == pytest.approx(1.0, abs=0.12)


@pytest.mark.parametrize(
    ("places", "where", "time", "expected"),
    [
        ({"tide_x": 0.01, "tide_y": -0.02, "tide_period": 100.0, "tide_phase": 0.5}, (1, 2, -1), 30.0, "tide"),
        ({"current_x": 0.01, "shear_yz": 0.002, "shear_depth": 1e6}, (1, 2, -1), 0.0, (0.01, -0.002)),
        ({"shear_xy": 0.002, "shear_width": 4.0}, (1, 2, -1), 0.0, (0.008 * math.tanh(0.5), 0.0)),
        ({"shear_yx": 0.002, "shear_width": 1e6}, (1, 2, -1), 0.0, (0.0, 0.002)),
        ({"vortex": 0.1, "vortex_core": 0.01}, (0, 2, -1), 0.0, (-0.1 / (4 * math.pi), 0.0)),
        ({"vortex": 0.1, "vortex_core": 2.0}, (2, 0, -1), 0.0, (0.0, 0.1 * (1 - math.exp(-1)) / (4 * math.pi))),
    ],
)
def test_the_water_moves_as_its_law_says(places: dict[str, float], where: Any, time: float, expected: Any) -> None:
    """Velocity of the water at a place and time, by hand."""
    from concealer import layout as at
    from concealer.fluid import current

    p, s = at.nominal_robot(), np.zeros(at.STATE)
    s[:3] = where
    for name, value in places.items():
        p[getattr(at, name.upper())] = value
    if expected == "tide":
        wave = math.sin(2 * math.pi * 0.3 + 0.5)
        expected = (0.01 * wave, -0.02 * wave)
    assert current(p, s, time) == pytest.approx(expected, abs=1e-9)


def test_a_battery_loses_what_it_is_said_to_lose() -> None:
    """Nothing at first, all of the fraction when the charge is used up, about two thirds of it half-way."""
    from concealer import layout as at
    from concealer.drives import left_in_battery

    p = at.nominal_robot()
    p[at.BATTERY], p[at.DURATION] = 0.2, 600.0
    assert left_in_battery(p, 0.0) == 1.0
    assert left_in_battery(p, 600.0) == pytest.approx(0.8, abs=1e-5)
    assert left_in_battery(p, 300.0) == pytest.approx(1 - 0.2 * (0.2 + 0.325 + 0.15 / 64), abs=1e-3)


def test_the_pumps_lag_is_of_first_order(run: Run) -> None:
    """w' = pump (1 - exp(-t / T)) / m without drag."""
    rows = run((0.0, 0.0, 0.01), 4.0, drag=0.0, pump_lag=0.8)
    speed = 0.01 * PUMP / MASS * (4.0 - 0.8 * (1.0 - math.exp(-5.0)))
    assert rows[-1, 6] == pytest.approx(speed, rel=1e-4)
