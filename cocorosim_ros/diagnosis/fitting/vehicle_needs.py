"""Needs of effects: what a vehicle must have to show one. Where it has not, no diagnosis looks for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from cocorosim_ros.diagnosis.tracks.vehicle_model import VehicleModel

HAS: Mapping[str, Callable[[VehicleModel], bool]] = {
    "thrusters": lambda vehicle: bool(vehicle.is_thruster.any()),
}
"""Tell by name whether a vehicle has something that effects need."""
