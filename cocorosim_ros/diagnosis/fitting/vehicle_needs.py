"""Needs of effects: what a vehicle must have to show one. Where it has not, no diagnosis looks for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import VEHICLE_NEEDS
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel


def _has_side_thrusters(vehicle: VehicleModel) -> bool:
    to_the_side = np.abs(vehicle.actuator_wrench[vehicle.is_thruster, 1])
    return bool((to_the_side > VEHICLE_NEEDS.pushes).any())


HAS: Mapping[str, Callable[[VehicleModel], bool]] = {
    "above_water": lambda vehicle: any(vehicle.above_water),
    "cable": lambda vehicle: vehicle.cable[0] > 0.0,
    "thrusters": lambda vehicle: bool(vehicle.is_thruster.any()),
    "side_thrusters": _has_side_thrusters,
    "tall_hull": lambda vehicle: vehicle.height >= VEHICLE_NEEDS.tall,
}
"""Tell by name whether a vehicle has something that effects need."""
