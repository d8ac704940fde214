"""Needs of effects: what a vehicle must have to show one. Where it has not, no diagnosis looks for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel

TALL = 0.1
"""[m] A hull of this height bobs at the surface by one radian in 0.1 s, which the filter's steps just follow."""
_PUSHES = 1e-6  # of a unit of force: less is rounding in a direction

HAS: Mapping[str, Callable[[VehicleModel], bool]] = {
    "thrusters": lambda vehicle: bool(vehicle.is_thruster.any()),
    "side_thrusters": lambda vehicle: bool((np.abs(vehicle.actuator_wrench[vehicle.is_thruster, 1]) > _PUSHES).any()),
    "tall_hull": lambda vehicle: vehicle.height >= TALL,
}
"""Tell by name whether a vehicle has something that effects need."""
