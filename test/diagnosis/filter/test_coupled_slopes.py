"""How a random force moves surge, sway and yaw of a vehicle whose centre of mass is off its origin, by the matrix."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity

YAW_THERE, AHEAD, LEFT, ADDED = 0.7, 0.012, -0.005, 0.05  # rad, m, m, kg


def slopes_by_force(effects: Any) -> Any:
    """(3, 3) derivatives of the rates of surge, sway and yaw by forces along x, y of the world and a moment."""
    from cocorosim_ros.diagnosis.filter.motion import make_motion, responses, write_slopes
    from cocorosim_ros.world.terms.blocks import HFX, HN, HORIZONTAL, HR, HU, VERTICAL
    from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles
    from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, Body

    vehicles = build_vehicles([replace(load_platform("lily"), effect_quantities=effects)])
    own = [part[0, 0] for part in vehicles]
    nowhere = (np.zeros(0), np.full(3, -1e9), np.full(3, 1e9), np.zeros((0, 5)), -1)
    body = Body(own[0], int(own[1]) | EFFECT_BIT["patch_force"], *own[2:], *nowhere)
    motion = make_motion(np.array([0.0, 0.0, -1.0, YAW_THERE, 0.04, 0.01, 0.0, 0.6]), body)
    response, across, upright = np.zeros(13), np.zeros(6 * HORIZONTAL), np.zeros(2 * VERTICAL)
    responses(motion, 0.0, body, response)
    write_slopes(motion, 0.0, body, response, across, upright)
    return across.reshape(6, HORIZONTAL)[HU : HR + 1, HFX : HN + 1]


@pytest.mark.parametrize("offset", [0.0, 1.0])
def test_they_are_the_inverse_of_the_mass_matrix(offset: float) -> None:
    """Forces of the world are turned into body axes; without an offset nothing stands beside the diagonal blocks."""
    lily, x, y = load_platform("lily"), offset * AHEAD, offset * LEFT
    effects = {"added_mass": {"sway_minus_surge": Quantity(ADDED, "kg", "mass")}}
    if offset:
        effects["offset_centre"] = {"ahead": Quantity(x, "m", "length"), "left": Quantity(y, "m", "length")}
    mass, about_origin = lily.mass, lily.yaw_inertia + lily.mass * (x**2 + y**2)
    matrix = np.array([[mass, 0.0, -mass * y], [0.0, mass + ADDED, mass * x], [-mass * y, mass * x, about_origin]])
    cosine, sine = math.cos(YAW_THERE), math.sin(YAW_THERE)
    turned = np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    # Differences over 1e-4 N of rates of up to 1 leave 1e-11 over.
    np.testing.assert_allclose(slopes_by_force(effects), np.linalg.solve(matrix, turned), rtol=1e-9, atol=1e-9)
