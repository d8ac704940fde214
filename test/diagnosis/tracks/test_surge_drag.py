"""A factor of the drag ahead alone slows the hull ahead, and leaves what it feels to the side and upwards."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.columns import COLUMN, OWN_SURGE_DRAG
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.effects.anisotropic_drag import (
    EACH_AXIS,
    EACH_AXIS_STRIPS,
    OWN_SPEED,
    STRIPS,
    TOTAL_SPEED,
)
from cocorosim_ros.world.motion.dynamics import state_rate
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, row_size

FACTOR = 1.6
ALONE = [[0.3, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, -0.1]]
"""Motions along one axis [m/s; body]."""


def acceleration(velocity: list[float], form: float, factor: float) -> Any:
    """Accelerations (3,) [m/s^2; body] of a Lily without thrust, whose ratios of drag are 2.4 and 1.3."""
    vehicle = vehicle_model(load_platform("lily"))
    row = vehicle.row
    numbers = {"sway_ratio": 2.4, "heave_ratio": 1.3, "form": form, "length": 0.13}
    row[[COLUMN[f"anisotropic_drag.{name}"] for name in numbers]] = list(numbers.values())
    row[COLUMN[OWN_SURGE_DRAG]] = factor
    state, rate = np.zeros((2, row_size(len(vehicle.is_pump))))
    state[[SURGE, SWAY, HEAVE]] = velocity
    state_rate(state, 0.0, vehicle.body(row), rate)
    return rate[[SURGE, SWAY, HEAVE]]


@pytest.mark.parametrize("form", [TOTAL_SPEED, OWN_SPEED, STRIPS, EACH_AXIS, EACH_AXIS_STRIPS])
@pytest.mark.parametrize("velocity", ALONE, ids=["ahead", "aside", "down"])
def test_only_motion_ahead_is_slowed_more(velocity: list[float], form: float) -> None:
    """By the factor; motion along another axis is slowed as before."""
    before, after = (acceleration(velocity, form, each) for each in (1.0, FACTOR))
    assert abs(before[np.argmax(np.abs(velocity))]) > 0.01
    np.testing.assert_allclose(after, before * [FACTOR, 1.0, 1.0], rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("form", [TOTAL_SPEED, EACH_AXIS, EACH_AXIS_STRIPS])
def test_motion_along_all_axes_at_once_is_too(form: float) -> None:
    """The drag along the other axes does not know of that ahead where the whole drag has one form."""
    before, after = (acceleration([0.3, 0.2, -0.1], form, each) for each in (1.0, FACTOR))
    np.testing.assert_allclose(after, before * [FACTOR, 1.0, 1.0], rtol=1e-12)
