"""Curves of thrusters that are bent: closed forms between rest and full command."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.bent_curves import bent_curves
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.terms.curve import LINEAR, SQUARE, TABLE, thrust_share

COMMANDS = np.linspace(-1.0, 1.0, 201)


def shares(curve: Floats) -> Floats:
    """Shares of the limit at COMMANDS."""
    return np.array([thrust_share(curve, command) for command in COMMANDS.tolist()])


def test_a_straight_line_bent_by_one_is_a_square_law() -> None:
    """Within what a table errs by between its points; the other thruster keeps its line to the bit."""
    bent, straight = bent_curves(np.zeros((2, 0)), np.array([1.0, 0.0]))
    assert shares(bent) == pytest.approx(COMMANDS * np.abs(COMMANDS), abs=2e-4)
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
@pytest.mark.parametrize("bend", [-1.0, -0.4, 0.6, 1.0])
def test_a_bend_keeps_rest_full_command_and_dead_bands(curve: list[float], bend: float) -> None:
    """By the definition at each command; thrust rises with the command wherever it did before."""
    before = shares(np.array(curve))
    (row,) = bent_curves(np.array([curve]), np.array([bend]))
    after = shares(row)
    assert after == pytest.approx(before * (1.0 + bend * (np.abs(before) - 1.0)), abs=2e-3)
    assert (after[before == 0.0] == 0.0).all()
    assert after[[0, -1]].tolist() == [-1.0, 1.0]
    assert (np.diff(after) >= -1e-12).all()


def test_a_row_bends_the_thruster_with_its_number() -> None:
    """Lily's second thruster, and no pump; without bends the body has the platform's own curves."""
    vehicle = vehicle_model(load_platform("lily"))
    row = vehicle.row
    assert vehicle.actuating_body(row).actuator_curve is vehicle.actuator_curve
    row[COLUMN["own_bend.2"]] = 0.5
    curve = vehicle.actuating_body(row).actuator_curve
    halves = [thrust_share(own, 0.5) for own in curve]
    assert halves == pytest.approx([0.5, 0.375, 0.5])
