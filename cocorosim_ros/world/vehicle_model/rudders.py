"""From the rudders of a platform to the numbers of the effects that act for them."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.steering import Rudder
from cocorosim_ros.world.effects import RUDDERS
from cocorosim_ros.world.effects.rudder import RUDDER

NEUTRAL = {number.name: number.neutral for number in RUDDER.parameters}
OWN_NUMBERS = (
    "gain", "wake", "acceleration", "coverage", "straightening", "inflow_arm", "drag_share", "hull_gain",
    "hull_position", "trim",
)  # fmt: skip
"""Numbers that a platform's file may leave open, by the same names there and in the effect."""


def lift_slope(aspect_ratio: float) -> float:
    """Normal force over 1/2 rho A U^2 sin(alpha): Fujii's 6.13 L / (L + 2.25), Yasukawa and Yoshimura 2015, (21)."""
    return 6.13 * aspect_ratio / (aspect_ratio + 2.25)


def rudders_of(platform: Platform) -> Iterator[tuple[str, Rudder]]:
    """Each rudder, with the effect that acts for it."""
    yield from zip(RUDDERS, (part for part in platform.actuators if isinstance(part, Rudder)), strict=False)


def rudder_numbers(platform: Platform) -> dict[str, float]:
    """The numbers of all rudders by column."""
    return {
        f"{effect}.{name}": value
        for effect, rudder in rudders_of(platform)
        for name, value in _numbers(platform, rudder).items()
    }


def _numbers(platform: Platform, rudder: Rudder) -> dict[str, float]:
    names = platform.actuator_names
    numbers = {
        "actuator": float(names.index(rudder.name)),
        "propeller": -1.0 if rudder.propeller is None else float(names.index(rudder.propeller)),
        "x": rudder.position[0],
        "y": rudder.position[1],
        "area": rudder.area,
        "slope": lift_slope(rudder.aspect_ratio),
        "density": platform.water_density,
        "diameter": rudder.propeller_diameter or 0.0,
    }
    for name in OWN_NUMBERS:
        given: float | None = getattr(rudder, name)
        without = rudder.position[0] if name == "inflow_arm" else NEUTRAL[name]
        numbers[name] = without if given is None else given
    return numbers


def rudder_forces(platform: Platform, speed: float) -> Floats:
    """(4,) amounts of X, Y, Z and N of all rudders at their largest angles, without a jet, at a speed [m/s]."""
    total = np.zeros(4)
    for _, rudder in rudders_of(platform):
        sine, cosine = math.sin(rudder.largest_angle), math.cos(rudder.largest_angle)
        normal = 0.5 * platform.water_density * rudder.area * lift_slope(rudder.aspect_ratio) * speed**2 * sine
        total += normal * np.array([sine, cosine, 0.0, abs(rudder.position[0]) * cosine])
    return total
