"""From a current as a scenario asks for it to the numbers that compiled loops read."""

from __future__ import annotations

import dataclasses

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.currents import GriddedCurrent, VelocityCurrent
from cocorosim_ros.world.water.currents import CURRENTS


def current_numbers(current: VelocityCurrent) -> Floats:
    """The numbers of a current in the order of its entry in CURRENTS, SI units."""
    if isinstance(current, GriddedCurrent):
        return current.file.numbers
    values = dataclasses.asdict(current)
    return np.array([values[name] for name in CURRENTS[current.kind].parameters])
