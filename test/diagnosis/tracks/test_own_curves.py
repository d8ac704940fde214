"""Curves of single thrusters by another power: closed forms between rest and full command."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.own_curves import own_curves
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.terms.curve import LINEAR, SQUARE, TABLE, thrust_share

COMMANDS = np.linspace(-1.0, 1.0, 201)


def shares(curve: Floats) -> Floats:
    """Shares of the limit at COMMANDS."""
    return np.array([thrust_share(curve, command) for command in COMMANDS.tolist()])


def test_the_second_power_of_a_straight_line_is_a_square_law() -> None:
    """Within what a table errs by between its points; the other thruster keeps its line to the bit."""
    square, straight = own_curves(np.zeros((2, 0)), np.array([2.0, 1.0]))
    assert shares(square) == pytest.approx(COMMANDS * np.abs(COMMANDS), abs=7e-4)
    assert shares(straight).tolist() == COMMANDS.tolist()


@pytest.mark.parametrize(
    "curve",
    [
        [LINEAR, 0.12],
        [SQUARE, 0.07],
        [TABLE, 4.0, -1.0, -0.13, 0.21, 1.0, -1.0, 0.0, 0.0, 1.0],
    ],
    ids=["dead band", "square with a dead band", "table"],
)
@pytest.mark.parametrize("exponent", [0.8, 1.5, 2.0])
def test_a_power_keeps_rest_full_command_and_dead_bands(curve: list[float], exponent: float) -> None:
    """By the definition at each command; thrust rises with the command wherever it did before."""
    before = shares(np.array(curve))
    (row,) = own_curves(np.array([curve]), np.array([exponent]))
    after = shares(row)
    assert after == pytest.approx(np.sign(before) * np.abs(before) ** exponent, abs=0.01)
    assert (after[before == 0.0] == 0.0).all()
    assert after[[0, -1]].tolist() == [-1.0, 1.0]
    assert (np.diff(after) >= -1e-12).all()


def test_a_row_gives_the_thruster_with_its_number_a_curve() -> None:
    """Lily's second thruster, and no pump; with exponents of 1 the body has the platform's own curves."""
    vehicle = vehicle_model(load_platform("lily"))
    row = vehicle.row
    assert row[COLUMN["own_exponent.2"]] == 1.0
    assert vehicle.actuating_body(row).actuator_curve is vehicle.actuator_curve
    row[COLUMN["own_exponent.2"]] = 2.0
    curve = vehicle.actuating_body(row).actuator_curve
    assert [thrust_share(own, 0.5) for own in curve] == pytest.approx([0.5, 0.25, 0.5], abs=7e-4)
