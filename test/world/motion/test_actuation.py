"""From commands to forces: exact means behind a lag, dead band, gains, play, each by a closed form or by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.state.state import HEAVE, MEMORY_SIZE, STATE_SIZE, SURGE, YAW_RATE, Z

Make = Callable[..., Any]
OFF = (0.0, 0.0, 0.0)


@pytest.fixture
def actuated(robots: Make) -> Make:
    """Function of (numbers, commands, and duration, start): forces (n, 3) of a Lily over n intervals."""
    from cocorosim_ros.world.motion.actuation import actuate
    from cocorosim_ros.world.vehicle_model.vehicles import Body

    def run(numbers: Any, commands: Any, duration: float = 0.5, start: float = 0.0) -> Any:
        own = tuple(part[0, 0] for part in robots(numbers))
        nowhere = (np.zeros(0), np.zeros(3), np.zeros(3), np.zeros((0, 5)), -1)
        body = Body(own[0], int(own[1]), *own[2:], *nowhere)
        memory, force, forces = np.zeros(3 * MEMORY_SIZE), np.zeros(3), []
        for number, command in enumerate(commands):
            told = np.array(command, dtype=float)
            actuate(told, memory, body, Interval(start + number * duration, duration), force)
            forces.append(force.copy())
        return np.array(forces)

    return run


def test_a_lag_gives_the_exact_impulse_in_any_steps(swim: Make, lily: SimpleNamespace) -> None:
    """After a step of the command: m u = F (t - tau (1 - exp(-t / tau))), in one, two or seven steps a tick."""
    time, tau = 0.5 * np.arange(9), 0.3
    expected = 2 * lily.thrust / lily.mass * (time + tau * np.expm1(-time / tau))
    for steps in (1, 2, 7):
        path = swim({"thruster_lag.time_constant": tau}, {}, [(1, 1, 0)] * 8, steps=steps)
        np.testing.assert_allclose(path[:, 0, SURGE], expected, rtol=1e-12, atol=1e-18)


def test_the_force_shown_at_a_tick_is_that_of_the_moment(swim: Make, lily: SimpleNamespace) -> None:
    """At the end of a tick the state holds F (1 - exp(-t / tau)), not the mean of the last step."""
    path = swim({"thruster_lag.time_constant": 0.8}, {}, [(1, -0.5, 0.3)] * 4, steps=2)
    rise = -np.expm1(-0.5 * np.arange(5) / 0.8)
    np.testing.assert_allclose(path[:, 0, STATE_SIZE], lily.thrust * rise, rtol=1e-12)
    np.testing.assert_allclose(path[:, 0, STATE_SIZE + 1], -0.5 * lily.thrust * rise, rtol=1e-12)
    np.testing.assert_allclose(path[1:, 0, STATE_SIZE + 2], 0.3 * lily.pump, rtol=1e-12)


def test_a_lag_shorter_than_a_step(actuated: Make, lily: SimpleNamespace) -> None:
    """With 50 ms in a step of 0.5 s nine tenths (and exp(-10) of one) of the force are the mean of the first step."""
    forces = actuated({"thruster_lag.time_constant": 0.05}, [(1, 0, 0)])
    assert forces[0, 0] / lily.thrust == pytest.approx(1 - 0.1 * (1 - math.exp(-10)), rel=1e-12)


def test_lags_concern_their_own_kind(actuated: Make, lily: SimpleNamespace) -> None:
    """That of the thrusters leaves the pump alone, that of the pump the thrusters."""
    thrusters = actuated({"thruster_lag.time_constant": 1.0}, [(1, 1, 1)])[0]
    pump = actuated({"pump_lag.time_constant": 1.0}, [(1, 1, 1)])[0]
    behind = 1 - 2 * (1 - math.exp(-0.5))
    np.testing.assert_allclose(thrusters, [lily.thrust * behind, lily.thrust * behind, lily.pump], rtol=1e-12)
    np.testing.assert_allclose(pump, [lily.thrust, lily.thrust, lily.pump * behind], rtol=1e-12)


@pytest.mark.parametrize("exponent", [0.5, 1.0, 2.0, 2.5])
def test_another_curve_gives_the_same_at_rest_and_at_full_command(
    actuated: Make, lily: SimpleNamespace, exponent: float
) -> None:
    """In between a power of the command, forwards as backwards; the pump keeps its line."""
    shares = np.array([-1.0, -0.5, 0.0, 0.2, 1.0])
    law = np.sign(shares) * np.abs(shares) ** exponent
    forces = actuated({"thrust_curve.exponent": exponent}, [(share, -share, share) for share in shares])
    np.testing.assert_allclose(forces[:, 0], lily.thrust * law, rtol=1e-12, atol=1e-18)
    np.testing.assert_allclose(forces[:, 1], -lily.thrust * law, rtol=1e-12, atol=1e-18)
    np.testing.assert_allclose(forces[:, 2], lily.pump * shares, rtol=1e-12, atol=1e-18)


def test_the_curve_comes_before_what_a_weaker_thruster_loses(actuated: Make, lily: SimpleNamespace) -> None:
    """The power is that of the command alone; what a difference between the thrusters takes is no part of it."""
    numbers = {"thrust_curve.exponent": 2.0, "thruster_asymmetry.difference": 0.2}
    forces = actuated(numbers, [(0.5, 0.5, 0.0)])[0]
    np.testing.assert_allclose(forces[:2], lily.thrust * 0.25 * np.array([0.9, 1.1]), rtol=1e-12)


def test_a_pump_with_backlash(actuated: Make, lily: SimpleNamespace) -> None:
    """Up to +0.5 and back: a play of 0.2 takes 0.1 off on the way there and adds it on the way back."""
    commands = [0.05, 0.3, 0.5, 0.45, 0.35, 0.2, 0.0, -0.5, -0.4]
    forces = actuated({"pump_lag.backlash": 0.2}, [(0, 0, command) for command in commands])
    expected = [0.0, 0.2, 0.4, 0.4, 0.4, 0.3, 0.1, -0.4, -0.4]
    np.testing.assert_allclose(forces[:, 2] / lily.pump, expected, rtol=0, atol=1e-12)


def test_a_slow_pump_lifts_by_its_impulse(swim: Make, lily: SimpleNamespace) -> None:
    """A slow pump without drag: m w = B (t - tau (1 - exp(-t / tau)))."""
    path = swim({"pump_lag.time_constant": 2.0}, {Z: -30.0}, [(0, 0, 0.1)] * 8)
    time = 0.5 * np.arange(9)
    expected = 0.1 * lily.pump / lily.mass * (time + 2.0 * np.expm1(-time / 2.0))
    np.testing.assert_allclose(path[:, 0, HEAVE], expected, rtol=1e-12, atol=1e-18)


def test_a_dead_band(actuated: Make, lily: SimpleNamespace) -> None:
    """Below the width nothing, from it on the whole command, forwards and backwards; the pump has none."""
    commands = [(0.04, -0.04, 0.04), (0.06, -0.06, 0.0), (1.0, -1.0, -0.01)]
    forces = actuated({"thruster_deadband.width": 0.05}, commands)
    shares = [[0.0, 0.0, 0.04], [0.06, -0.06, 0.0], [1.0, -1.0, -0.01]]
    np.testing.assert_allclose(forces, np.array(shares) * [lily.thrust, lily.thrust, lily.pump], rtol=1e-12)


@pytest.mark.parametrize("difference", [0.06, -0.06])
def test_unequal_thrusters(actuated: Make, lily: SimpleNamespace, difference: float) -> None:
    """(right - left) / mean is the difference, at every command; the pump is as it was."""
    left, right, pump = actuated({"thruster_asymmetry.difference": difference}, [(0.5, 0.5, 0.5)])[0]
    assert (right - left) / (0.5 * (right + left)) == pytest.approx(difference, rel=1e-12)
    assert (0.5 * (left + right), pump) == pytest.approx((0.5 * lily.thrust, 0.5 * lily.pump), rel=1e-12)


def test_unequal_thrusters_turn_a_robot(swim: Make, lily: SimpleNamespace) -> None:
    """3 % at full thrust turn a Lily steadily with sqrt(N / Cr), N = 0.03 F b: counter-clockwise for a strong right."""
    numbers = {"drag": lily.drag, "yaw_drag": lily.yaw_drag, "thruster_asymmetry.difference": 0.03}
    rate = math.sqrt(0.03 * lily.thrust * lily.lever / lily.yaw_drag)
    assert swim(numbers, {}, [(1, 1, 0)] * 400)[-1, 0, YAW_RATE] == pytest.approx(rate, rel=1e-6)


def test_weaker_backwards(actuated: Make, lily: SimpleNamespace) -> None:
    """A loss of 0.2 leaves four fifths of a backward thrust, and all of a forward one."""
    left, right, pump = actuated({"reverse_loss.loss": 0.2}, [(-0.5, 0.5, -0.5)])[0]
    assert (left, right, pump) == pytest.approx((-0.4 * lily.thrust, 0.5 * lily.thrust, -0.5 * lily.pump), rel=1e-12)


def test_a_battery_that_sags(actuated: Make, lily: SimpleNamespace) -> None:
    """Over 100 s a fifth is lost in a straight line, each interval at its middle; later no more; not the pump's."""
    numbers = {"battery_sag.fraction_lost": 0.2, "battery_sag.duration": 100.0}
    early = actuated(numbers, [(1, 1, 1)], start=49.75)[0]
    late = actuated(numbers, [(1, 1, 1)], start=300.0)[0]
    np.testing.assert_allclose(early, [0.9 * lily.thrust, 0.9 * lily.thrust, lily.pump], rtol=1e-12)
    np.testing.assert_allclose(late, [0.8 * lily.thrust, 0.8 * lily.thrust, lily.pump], rtol=1e-12)


def test_gains(actuated: Make, lily: SimpleNamespace) -> None:
    """What pushes together, what turns, and what lifts have a gain each."""
    numbers = {"thrust_gain": 0.9, "yaw_torque_gain": 1.2, "buoyancy_gain": 1.1}
    left, right, pump = actuated(numbers, [(0.2, 0.6, 0.5)])[0] / [lily.thrust, lily.thrust, lily.pump]
    assert (left + right, right - left, pump) == pytest.approx((0.9 * 0.8, 1.2 * 0.4, 1.1 * 0.5), rel=1e-12)


def test_gains_come_behind_a_lag(actuated: Make, lily: SimpleNamespace) -> None:
    """With a lag the gains scale the same forces."""
    commands, lag = [(1, 0.3, 0), (0, 0.5, 0), (0.2, -1, 0)], {"thruster_lag.time_constant": 0.7}
    plain, scaled = actuated(lag, commands), actuated({**lag, "thrust_gain": 0.8, "yaw_torque_gain": 0.8}, commands)
    np.testing.assert_allclose(scaled, 0.8 * plain, rtol=1e-12)


@pytest.mark.parametrize("command", [(math.nan, 5.0, -5.0)])
def test_what_no_actuator_can_do(actuated: Make, lily: SimpleNamespace, command: tuple[float, ...]) -> None:
    """NaN is off, what is beyond the limits is the limit, with effects and without."""
    for numbers in ({}, {"thruster_deadband.width": 0.05}):
        np.testing.assert_allclose(actuated(numbers, [command])[0], [0.0, lily.thrust, -lily.pump], rtol=1e-15)
