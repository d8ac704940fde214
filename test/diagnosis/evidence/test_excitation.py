"""Shares of the time in which an actuator is varied, reversed, off, near zero, counted by hand."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.excitation import command_use
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream

NAMES = ("left", "right")


def log(time: list[float], left: list[float], right: list[float], end: float) -> RobotLog:
    """A robot with two actuators, and readings until `end`."""
    pose = Stream(np.array([0.0, end]), np.zeros((2, 4)), np.full(4, np.nan))
    return RobotLog("lily_01", np.array(time), np.column_stack([left, right]), {"pose": pose})


def test_shares_are_of_the_time_not_of_the_messages() -> None:
    """Commands at 0, 10, 11, 12 s, the last one held until 20 s."""
    left, right = command_use(log([0, 10, 11, 12], [0.0, 0.5, -0.5, 0.05], [1.0, 1.0, 1.0, 1.0], 20.0), NAMES)
    assert (left.actuator, right.actuator) == NAMES
    assert left.off == pytest.approx(10 / 20)
    assert left.reversed == pytest.approx(1 / 20)
    assert left.near_zero == pytest.approx(8 / 20)
    assert left.varied == pytest.approx(10 / 20)
    assert (left.steps, left.lowest, left.highest) == (3, -0.5, 0.5)
    assert (right.off, right.reversed, right.near_zero, right.varied, right.steps) == (0.0, 0.0, 0.0, 0.0, 0)


def test_a_ramp_is_varied_without_steps() -> None:
    """Small changes all the time; what hums by less than a hair does not."""
    time = np.arange(0.0, 20.0, 0.1)
    ramp, hum = command_use(log(time.tolist(), (0.02 * time).tolist(), (1e-4 * np.sin(9 * time)).tolist(), 20.0), NAMES)
    assert ramp.steps == 0 and hum.varied == 0.0
    assert ramp.varied > 0.9


def test_long_after_a_change_nothing_is_varied() -> None:
    """Five seconds after the last change the actuator counts as still."""
    time = np.arange(0.0, 100.0, 1.0)
    (left, _) = command_use(log(time.tolist(), (0.5 * (time >= 50.0)).tolist(), (0 * time).tolist(), 100.0), NAMES)
    assert left.varied == pytest.approx(6 / 100)
    assert left.steps == 1


def test_no_commands() -> None:
    """Nothing to be said."""
    assert command_use(RobotLog("a", np.empty(0), np.empty((0, 2)), {}), NAMES) == ()
    (left, _) = command_use(RobotLog("a", np.zeros(1), np.array([[0.2, 0.0]]), {}), NAMES)
    assert (left.lowest, left.off, left.near_zero) == (0.2, 0.0, 0.0)
