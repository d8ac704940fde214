"""Angles that are reported act in place of those ordered, where they can be trusted."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.evidence.following.reported_angles import with_reported_angles
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection, corrected
from cocorosim_ros.diagnosis.evidence.streams.feedback import Feedback
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.grid import Grid
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import Platform, load_platform

Floats = NDArray[np.float64]
SPAN, RATE = 200.0, 10.0  # s, Hz
SLEW = math.radians(8.0)  # rad/s
LARGEST = math.pi  # of the ferry's pods


@pytest.fixture(scope="module")
def ferry() -> Platform:
    """Four thrusters, each turned about the vertical by half a turn at most."""
    return load_platform("milliampere_ferry")


def pod_of(platform: Platform) -> tuple[int, str]:
    """Column and name of the first actuator that turns."""
    column = next(place for place, each in enumerate(platform.actuators) if hasattr(each, "largest_angle"))
    return column, platform.actuator_names[column]


def turned(ordered: Floats, moments: Floats) -> Floats:
    """Where a pod of 8 deg/s stands that is ordered every 10 s: by steps of a millisecond, a calculation of its own."""
    angle, place, course = ordered[0] * LARGEST, 0.0, np.empty(len(moments))
    for count, moment in enumerate(moments.tolist()):
        while place < moment:
            asked = ordered[min(int(place / 10.0), len(ordered) - 1)] * LARGEST
            angle += min(max(asked - angle, -SLEW * 1e-3), SLEW * 1e-3)
            place += 1e-3
        course[count] = angle
    return course


def log_of(
    platform: Platform, scale: float = 1.0, quantity: str = "angle", silent: tuple[float, float] = (0.0, 0.0)
) -> RobotLog:
    """A pod with orders of up to 40 degrees every 10 s, reported `scale` times as large, but for a silence [s]."""
    column, name = pod_of(platform)
    ordered = np.random.default_rng(7).uniform(-40.0, 40.0, int(SPAN / 10.0)) / 180.0
    command = np.zeros((len(ordered), len(platform.actuators)))
    command[:, column] = ordered
    moments = np.arange(0.0, SPAN, 1.0 / RATE)
    moments = moments[(moments < silent[0]) | (moments >= silent[1])]
    report = Feedback(name, quantity, moments, scale * turned(ordered, moments))
    return RobotLog("ferry", 10.0 * np.arange(len(ordered)), command, {}, feedback=(report,))


def acting(platform: Platform, log: RobotLog) -> RobotLog:
    """The log as evidence holds it."""
    evidence = with_reported_angles(Evidence(platform, (RecordingLog("x", SPAN, (log,)),)))
    return evidence.recordings[0].robots[0]


def test_a_pod_pushes_by_where_it_stands(ferry: Platform) -> None:
    """The angle that acts is the reported one to within half a reading's way, and the order has no part in it."""
    (column, name), log = pod_of(ferry), acting(ferry, log_of(ferry))
    assert log.acting is not None and log.acting.reported == (name,)
    moments = np.arange(0.5, SPAN - 0.5, 0.013)
    acts = log.acts.command[np.searchsorted(log.acts.time, moments, side="right") - 1, column] * LARGEST
    stands = turned(log.command[:, column], moments)
    assert np.abs(acts - stands).max() < 0.51 * SLEW / RATE + 1e-3 * SLEW
    assert abs(float(np.mean(acts - stands))) < 0.05 * SLEW / RATE  # neither early nor late
    others = [each for each in range(len(ferry.actuators)) if each != column]
    assert not log.acts.command[:, others].any()


def test_its_thrust_is_turned_by_the_reported_angle(ferry: Platform) -> None:
    """The force on the hull, from orders and from reports, differs while the pod turns: the model's drive has it."""
    column, _ = pod_of(ferry)
    plain = log_of(ferry)
    command = plain.command.copy()
    command[:, next(each for each in range(command.shape[1]) if each != column)] = 0.5
    pushed, vehicle = acting(ferry, replace(plain, command=command)), vehicle_model(ferry)
    grid = Grid(0.0, 0.1, 1000)
    reported, ordered = (
        Actuation(vehicle, log, grid).drive(vehicle.row).force for log in (pushed, replace(pushed, acting=None))
    )
    assert np.abs(reported - ordered).max() > 0.1 * np.abs(ordered).max()


@pytest.mark.parametrize(("scale", "quantity"), [(-1.0, "angle"), (57.3, "angle"), (1.0, "rotation"), (1.0, "current")])
def test_what_is_not_its_angle_takes_no_place(scale: float, quantity: str, ferry: Platform) -> None:
    """An angle of the wrong direction, or in degrees, and numbers of motors."""
    log = acting(ferry, log_of(ferry, scale, quantity))
    assert log.acting is None
    assert log.acts.command is log.command


def test_in_a_silence_the_order_acts(ferry: Platform) -> None:
    """From the last report before to the first one after, with no reading held on."""
    (column, _), log = pod_of(ferry), acting(ferry, log_of(ferry, silent=(80.0, 100.0)))
    for moment in (81.0, 89.0, 91.0, 99.0):
        acts = log.acts.command[np.searchsorted(log.acts.time, moment, side="right") - 1, column]
        assert acts == log.command[int(moment / 10.0), column]


def test_turned_commands_turn_the_angles_too(ferry: Platform) -> None:
    """A correction of commands, as of a mirrored axis, holds for what acts in their place."""
    log = acting(ferry, log_of(ferry))
    count = len(ferry.actuators)
    mirror = FrameCorrection("thruster_command", "mirrored", "made so", math.inf, -np.eye(count), np.zeros(count))
    found = corrected(log, [mirror])
    np.testing.assert_array_equal(found.acts.command, -log.acts.command)
    np.testing.assert_array_equal(found.command, -log.command)
