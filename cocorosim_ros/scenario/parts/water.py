"""The water of a scenario: still unless it says otherwise."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from cocorosim_ros.scenario.parts.currents import VELOCITY_CURRENTS, VelocityCurrent
from cocorosim_ros.scenario.parts.force_currents import FORCE_CURRENTS, ForceCurrents
from cocorosim_ros.scenario.parts.plume import Plume
from cocorosim_ros.scenario.reading.records import list_of, nested

_MICROMETRES = 1e6  # in a metre


@dataclass(frozen=True)
class Water:
    """Currents as velocities of the water, currents as forces on patches (the paper's), and what leaks into it."""

    currents: tuple[VelocityCurrent, ...] = field(default=(), metadata=list_of(VELOCITY_CURRENTS))
    force_currents: ForceCurrents | None = field(default=None, metadata=FORCE_CURRENTS)
    plume: Plume | None = field(default=None, metadata=nested(Plume))


def patch_counts(size: tuple[float, float, float], patch: float) -> tuple[int, int, int]:
    """How many patches [m] the tank [m] has along x, y and depth, to the nearest whole number."""
    x, y, z = (round(side / patch) for side in size)
    return x, y, z


def patch_that_divides(size: tuple[float, float, float], patch: float) -> float:
    """The length [m], near `patch`, that divides every side of a tank [m] of whole micrometres."""
    common = max(1, math.gcd(*(round(side * _MICROMETRES) for side in size)))
    wanted = min(common, max(1, round(common / (patch * _MICROMETRES))))
    near = (parts for off in range(common) for parts in (wanted - off, wanted + off))
    parts = next(parts for parts in near if parts >= 1 and common % parts == 0)
    return common / parts / _MICROMETRES
