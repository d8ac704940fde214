"""Choice of manoeuvres that would show what a recording leaves open, among those that the vehicle can drive."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.report import MANOEUVRE
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump, Thruster


def _has_pump(platform: Platform) -> bool:
    return any(isinstance(each, BuoyancyPump) for each in platform.actuators)


def _dives(platform: Platform) -> bool:
    return _has_pump(platform) or any(
        isinstance(each, Thruster) and abs(each.direction[2]) > MANOEUVRE.least_rise for each in platform.actuators
    )


def _reverses(platform: Platform) -> bool:
    return any(isinstance(each, Thruster) and each.maximum_reverse != 0.0 for each in platform.actuators)


NEEDS: dict[str, Callable[[Platform], bool]] = {
    "depth_staircase": _dives,
    "surface_touch": _dives,
    "pump_triangle": _has_pump,
    "reverse_steps": _reverses,
}
"""Actuators that a vehicle must have for a manoeuvre; the others need thrusters alone."""


def manoeuvre_of(effect: str) -> str | None:
    """Name of the manoeuvre that shows an effect of the catalogue, by its identifier; None if there is none."""
    return next((entry.manoeuvre for entry in ENTRIES if entry.id == effect and entry.manoeuvre), None)


def can_drive(platform: Platform, manoeuvre: str) -> bool:
    """Tell whether a vehicle has the actuators for a manoeuvre, given by name."""
    return manoeuvre not in NEEDS or NEEDS[manoeuvre](platform)


def advised(effects: Sequence[FoundEffect], unseen: Sequence[str], platform: Platform) -> tuple[str, ...]:
    """Choose up to three manoeuvres, by name, those first that serve most effects.

    They tell the found effects from their rivals, or, if there are no rivals, show effects that this recording could
    not show. A manoeuvre for which the vehicle has no actuator is never advised.
    """
    open_effects = [rival.id for effect in effects for rival in effect.ambiguous_with] + [
        effect.id for effect in effects if effect.ambiguous_with
    ]
    wanted = (manoeuvre_of(effect) for effect in dict.fromkeys(open_effects or unseen))
    names = [name for name in wanted if name and can_drive(platform, name)]
    return tuple(sorted(dict.fromkeys(names), key=lambda name: -names.count(name))[:3])
