"""From recorded commands to forces on the grid."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.diagnosis.tracks.actuation import Actuation
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.state.state import Z

LIFT = 1000.0 * 9.81 * 10e-6  # N of the pump at full command


@pytest.fixture
def steps() -> Actuation:
    """A Lily whose pump goes from nothing to half at 1 s, thrusters off, on a grid of 0.25 s."""
    commands = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.5]])
    log = RobotLog("lily_01", np.array([0.0, 1.0]), commands, {})
    return Actuation(vehicle_model(load_platform("lily")), log, Grid(0.0, 0.25, 13))


def test_a_command_acts_from_its_moment_on(steps: Actuation) -> None:
    """Nothing until 1 s, then half of the pump's lift; the thrusters nothing at all."""
    drive = steps.drive(steps.vehicle.row)
    np.testing.assert_allclose(steps.lift(drive), [0.0] * 4 + [0.5 * LIFT] * 9)
    assert not steps.thrust(drive).any()


def test_thrusters_upwards_lift_as_pumps_do() -> None:
    """A BlueROV2 has four of them among eight, of which one is told half of its force."""
    rov = load_platform("bluerov2_heavy")
    upwards = np.flatnonzero(vehicle_model(rov).actuator_wrench[:, Z])
    commands = np.ones((1, 8))
    commands[0, upwards] = [0.5, 0.0, 0.0, 0.0]
    driven = Actuation(vehicle_model(rov), RobotLog("rov", np.zeros(1), commands, {}), Grid(0.0, 0.25, 200))
    drive = driven.drive(driven.vehicle.row)
    assert len(upwards) == 4 and drive.force[-1, upwards[0]] > 1.0
    np.testing.assert_allclose(driven.lift(drive)[-1], drive.force[-1, upwards[0]])


def test_a_number_of_the_row_changes_the_force(steps: Actuation) -> None:
    """A gain of 1.2 of the pumps, after one of 1 was asked for and before it is asked for again."""
    plain, stronger = steps.vehicle.row, steps.vehicle.row
    stronger[COLUMN["buoyancy_gain"]] *= 1.2
    before = steps.lift(steps.drive(plain))
    np.testing.assert_allclose(steps.lift(steps.drive(stronger)), 1.2 * before)
    np.testing.assert_array_equal(steps.lift(steps.drive(plain)), before)


def test_rates_are_reckoned_only_for_those_who_ask(steps: Actuation) -> None:
    """Zero for a row without laws; else 0.5 s of memory: rate = F / T exp(-t / T) after a step, as the law feels it."""
    row = steps.vehicle.row
    assert not steps.drive(row).rate.any()
    asked = steps.drive(row, with_rates=True)
    np.testing.assert_array_equal(asked.force, steps.drive(row).force)
    rate = asked.rate[:, steps.vehicle.is_pump].sum(axis=1)
    assert not rate[:4].any()
    assert (np.diff(rate[4:]) < 0.0).all() and rate[4] > 0.0
    np.testing.assert_allclose(rate[5:] / rate[4:-1], np.exp(-0.25 / 0.5))


def test_a_law_that_is_in_the_row_asks_for_rates_itself(steps: Actuation) -> None:
    """The same rates as when they are asked for."""
    with_law = steps.vehicle.row
    with_law[COLUMN["law_1.coefficient"]] = 1e-3
    np.testing.assert_array_equal(steps.drive(with_law).rate, steps.drive(steps.vehicle.row, with_rates=True).rate)
