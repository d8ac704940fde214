"""Numbers on top of others: differences of some tracks from a number that all share."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown, nudged, write_values
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL

OWNER = Owner(PLATFORM, ("lily_01",), "drag", "kg/m")
DRAG = Unknown(OWNER, "drag", (0, 1), 2.0, logarithmic=True)
FACTOR = Unknown(OWNER, "drag", (1,), 1.0, 0.5, logarithmic=True, on_top=True)
LAG = Unknown(OWNER, "thruster_lag.time_constant", (0, 1), 0.0, 0.3)
MORE = Unknown(OWNER, "thruster_lag.time_constant", (1,), 0.0, 0.3, on_top=True)


def rows() -> np.ndarray:
    """Rows of two tracks."""
    return np.array([NEUTRAL, NEUTRAL])


def test_a_factor_multiplies_and_a_difference_adds_whatever_their_place() -> None:
    """2 e^0.1 kg/m for both tracks, times e^(0.5 0.4) for the second; 0.3 s * 0.5, and 0.3 s * 0.2 more."""
    q = np.array([0.4, 0.2, 0.1, 0.5])
    filled = write_values(rows(), [FACTOR, MORE, DRAG, LAG], q)
    assert filled[:, COLUMN["drag"]] == pytest.approx([2.0 * math.exp(0.1), 2.0 * math.exp(0.3)])
    assert filled[:, COLUMN["thruster_lag.time_constant"]] == pytest.approx([0.15, 0.21])


@pytest.mark.parametrize("number", range(4))
def test_a_step_of_one_number_leaves_the_other_in_place(number: int) -> None:
    """A nudged row of the second track is the row that all values give with the one number moved."""
    unknowns, q = [DRAG, LAG, FACTOR, MORE], np.array([0.1, 0.5, 0.4, 0.2])
    moved = q.copy()
    moved[number] += 0.01
    step = nudged(write_values(rows(), unknowns, q)[1], unknowns[number], float(q[number]), 0.01)
    assert step == pytest.approx(write_values(rows(), unknowns, moved)[1], rel=1e-12)
