"""Platforms that have effects of which a diagnosis is not told."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
from cocorosim_ros.world.effects import EFFECTS


def hiding(platform: Platform, effects: Mapping[str, Mapping[str, float]]) -> Platform:
    """Copy a platform that has these effects alone, by name: numbers in the units of the catalogue, by name."""
    return replace(platform, effect_quantities={name: _quantities(name, numbers) for name, numbers in effects.items()})


def _quantities(effect: str, numbers: Mapping[str, float]) -> dict[str, Quantity]:
    units = {part.name: "1" if part.unit == "*" else part.unit for part in EFFECTS[effect].parameters}
    return {name: Quantity(value, units[name], dimension_of(units[name])) for name, value in numbers.items()}
