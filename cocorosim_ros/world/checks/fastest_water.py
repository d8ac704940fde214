"""How fast the water of a scenario gets at most, as far as its currents are velocities."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.scenario.parts.currents import (
    GriddedCurrent,
    ShearedCurrent,
    TidalCurrent,
    UniformCurrent,
    VelocityCurrent,
    VortexCurrent,
)
from cocorosim_ros.scenario.scenario import Scenario

FASTEST_OF_VORTEX = 0.6382  # of circulation / (2 pi core): maximum of (1 - exp(-s^2)) / s


def fastest_water(scenario: Scenario) -> float:
    """The sum of the fastest speeds [m/s] of all currents in the tank; 0 in still water. Forces on patches are none."""
    currents = () if scenario.water is None else scenario.water.currents
    return sum(_fastest(current, scenario.tank.size) for current in currents)


def _fastest(current: VelocityCurrent, size: tuple[float, float, float]) -> float:
    match current:
        case UniformCurrent() | TidalCurrent():
            return math.hypot(current.x, current.y)
        case ShearedCurrent():
            along = abs(current.x) + abs(current.dx_dy) * 0.5 * size[1] + abs(current.dx_dz) * size[2]
            across = abs(current.y) + abs(current.dy_dx) * 0.5 * size[0] + abs(current.dy_dz) * size[2]
            return math.hypot(along, across)
        case VortexCurrent():
            return FASTEST_OF_VORTEX * abs(current.circulation) / (2.0 * math.pi * current.core)
        case GriddedCurrent():
            return _fastest_on_grid(current)


def _fastest_on_grid(current: GriddedCurrent) -> float:
    numbers = current.file.numbers
    counts = numbers[:4].astype(int)
    velocities = numbers[4 + counts.sum() :].reshape(-1, 3)
    return float(np.sqrt((velocities**2).sum(axis=1)).max())
