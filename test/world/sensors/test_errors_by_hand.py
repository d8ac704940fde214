"""Errors of logs, poses and compasses by hand: geometry, and the share of the motors."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.sensors.errors import ERROR_COLUMNS, NEUTRAL
from cocorosim_ros.world.sensors.errors.pose_lever import shown_x, shown_y
from cocorosim_ros.world.sensors.faults import add_errors
from cocorosim_ros.world.terms.motors import Motors, motor_share

Make = Callable[..., Any]
START = [[[0.0, 0.0, -1.0, 0.7]]]


def readings(make_simulation: Make, numbers: dict[str, float], forces: Any = (0.0, 0.0, 0.0), rate: float = 0.0) -> Any:
    """Readings of a robot at 0.3 m/s ahead, 0.1 m/s to the right and 0.02 m/s upwards, with these errors.

    rate: at which it turns to the left [rad/s].
    """
    simulation = make_simulation(START)
    simulation.state[0, 0, 4:8] = (0.3, -0.1, 0.02, rate)
    simulation.state[0, 0, 8:11] = forces
    simulation.world.instruments.measured[...] = True
    found, vehicles = simulation.sense(), simulation.world.vehicles
    error = np.array([NEUTRAL])
    for name, value in numbers.items():
        error[0, ERROR_COLUMNS[name]] = value
    motors = Motors(vehicles.is_pump, vehicles.actuator_curve, vehicles.actuator_limit)
    add_errors(5.0, error, simulation.state, motors, found)
    return found


def test_a_log_turned_to_the_left(make_simulation: Make) -> None:
    """Turned by a right angle its axes are left and astern: it shows v ahead and -u to the left."""
    shown = readings(make_simulation, {"speed_log_misalignment.angle": 0.5 * math.pi}).velocity[0, 0]
    np.testing.assert_allclose(shown[:3], [-0.1, -0.3, 0.02], atol=1e-15)


def test_a_log_that_shows_too_much_of_what_it_sees(make_simulation: Make) -> None:
    """Turned by an angle whose sine is 0.6, and 10 % too much: 1.1 (0.8 u + 0.6 v, 0.8 v - 0.6 u, w)."""
    numbers = {"speed_log_misalignment.angle": math.asin(0.6), "speed_log_scale.scale": 1.1}
    shown = readings(make_simulation, numbers).velocity[0, 0]
    expected = 1.1 * np.array([0.8 * 0.3 - 0.06, -0.08 - 0.18, 0.02])
    np.testing.assert_allclose(shown[:3], expected, atol=1e-15)


def test_a_log_off_the_origin(make_simulation: Make) -> None:
    """Half a metre ahead and a fifth to the left of it, in a turn of 0.8 rad/s: (u - 0.16, v + 0.4, w)."""
    numbers = {"speed_log_lever.ahead": 0.5, "speed_log_lever.left": 0.2}
    shown = readings(make_simulation, numbers, rate=0.8).velocity[0, 0]
    np.testing.assert_allclose(shown[:3], [0.14, 0.3, 0.02], atol=1e-15)


@pytest.mark.parametrize(("left", "right", "share"), [(1.0, 1.0, 1.0), (1.0, -1.0, 1.0), (-0.5, 0.0, 0.25), (0, 0, 0)])
def test_motors_turn_the_compass_by_what_they_give(
    make_simulation: Make, left: float, right: float, share: float
) -> None:
    """Each by its own amount, ahead or astern; 0.7 rad and a fifth of a radian at full thrust. A pump is no motor."""
    full = 0.005
    found = readings(make_simulation, {"motor_field.field": 0.2}, (left * full, right * full, 0.05))
    assert found.compass[0, 0] == pytest.approx(0.7 + 0.2 * share, abs=1e-12)


def test_soft_iron_errs_twice_a_turn(make_simulation: Make) -> None:
    """A quarter-circular deviation: at 0.7 rad it is D sin(1.4) + E cos(1.4), beside hard iron by B sin(0.7)."""
    found = readings(
        make_simulation, {"soft_iron.sin_2": 0.05, "soft_iron.cos_2": -0.02, "compass_distortion.sin": 0.1}
    )
    error = 0.05 * math.sin(1.4) - 0.02 * math.cos(1.4) + 0.1 * math.sin(0.7)
    assert found.compass[0, 0] == pytest.approx(0.7 + error, abs=1e-12)


def test_without_thrusters_no_motor_runs() -> None:
    """A glider with a pump alone."""
    motors = Motors(np.array([True]), np.zeros((1, 0)), np.ones((1, 2)))
    assert motor_share(np.ones(9), motors) == 0.0


@pytest.mark.parametrize(("heading", "place"), [(0.0, (1.3, 1.9)), (0.5 * math.pi, (1.1, 2.3)), (math.pi, (0.7, 2.1))])
def test_a_marker_goes_around_with_the_hull(heading: float, place: tuple[float, float]) -> None:
    """0.3 m ahead and 0.1 m to the right of a robot at (1, 2), by hand for three headings."""
    shown = shown_x(1.0, 1.0, 0.0, heading, 0.3, -0.1), shown_y(2.0, 2.0, 0.0, heading, 0.3, -0.1)
    assert shown == pytest.approx(place, abs=1e-12)
