"""Needs of effects: what a vehicle must have to show one. Where it has not, no diagnosis looks for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import VEHICLE_NEEDS
from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.terms.jet import BY, BY_TURNED, ON, ON_TURNED, left_of_jet


def _has_side_thrusters(vehicle: VehicleModel) -> bool:
    to_the_side = np.abs(vehicle.actuator_wrench[vehicle.is_thruster, 1])
    return bool((to_the_side > VEHICLE_NEEDS.pushes).any())


def _has_thruster_in_a_jet(vehicle: VehicleModel) -> bool:
    return any(_most_of_a_jet(vehicle, pair) > VEHICLE_NEEDS.in_a_jet for pair in vehicle.jets)


def _most_of_a_jet(vehicle: VehicleModel, pair: Floats) -> float:
    """The most of a jet that a thruster of a pair can feel, times the cosine between both pushes."""
    pushes = _directions(vehicle, int(pair[ON]), int(pair[ON_TURNED]))
    blowing = _directions(vehicle, int(pair[BY]), int(pair[BY_TURNED]))
    left = np.array([left_of_jet(pair, *(-direction).tolist()) for direction in blowing])
    return float((left * (pushes @ blowing.T)).max())


def _directions(vehicle: VehicleModel, thruster: int, azimuth: int) -> Floats:
    """Unit vectors (directions, 3) in which a thruster can push, forwards and, where it can, backwards [body]."""
    angles = np.zeros(1)
    if azimuth >= 0:
        backwards, forwards = -vehicle.actuator_limit[azimuth, 1], vehicle.actuator_limit[azimuth, 0]
        angles = np.linspace(backwards, forwards, VEHICLE_NEEDS.turned)
    wrench = vehicle.actuator_wrench
    ahead = np.outer(np.cos(angles), wrench[thruster, :3]) + np.outer(np.sin(angles), wrench[azimuth, :3])
    return np.vstack([ahead, -ahead]) if vehicle.actuator_limit[thruster, 1] > 0.0 else ahead


HAS: Mapping[str, Callable[[VehicleModel], bool]] = {
    "above_water": lambda vehicle: any(vehicle.above_water),
    "cable": lambda vehicle: vehicle.cable[0] > 0.0,
    "thrusters": lambda vehicle: bool(vehicle.is_thruster.any()),
    "side_thrusters": _has_side_thrusters,
    "thruster_in_a_jet": _has_thruster_in_a_jet,
    "slender_hull": lambda vehicle: vehicle.hull >= VEHICLE_NEEDS.slender * vehicle.width,
    "tall_hull": lambda vehicle: vehicle.height >= VEHICLE_NEEDS.tall,
}
"""Tell by name whether a vehicle has something that effects need."""


def moves_in_air(platform: Platform) -> bool:
    """Tell whether what a vehicle moves in is so thin that it is air."""
    return platform.water_density < VEHICLE_NEEDS.air


def has_all(vehicle: VehicleModel, needs: Sequence[str]) -> bool:
    """Tell whether a vehicle has all that an effect needs, by the names of HAS."""
    return all(HAS[need](vehicle) for need in needs)
