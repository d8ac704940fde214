"""From the currents that a scenario asks for to the numbers that compiled loops read."""

from __future__ import annotations

import dataclasses

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.currents import GriddedCurrent, VelocityCurrent
from cocorosim_ros.scenario.parts.ocean_current import OceanCurrent
from cocorosim_ros.scenario.parts.waves import Waves
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.seeding.seeding import generator
from cocorosim_ros.world.water.currents import CURRENTS
from cocorosim_ros.world.water.flow import CurrentAtWork
from cocorosim_ros.world.water.ocean.ocean_field import ocean_field
from cocorosim_ros.world.water.sea_state import sea_numbers


def scenario_currents(scenario: Scenario) -> list[CurrentAtWork]:
    """All currents of a scenario, each with its numbers in the order of its entry in CURRENTS, SI units.

    Raises OceanFileError where a file of an ocean model does not fit, which a scenario that is checked does not have.
    """
    currents = () if scenario.water is None else scenario.water.currents
    return [CurrentAtWork(each.kind, _numbers(each, scenario, place)) for place, each in enumerate(currents)]


def _numbers(current: VelocityCurrent, scenario: Scenario, place: int) -> Floats:
    """The numbers of the current at a place in the list, by which those of waves are random."""
    if isinstance(current, GriddedCurrent):
        return current.file.numbers
    if isinstance(current, OceanCurrent):
        return ocean_field(current, scenario.tank.size, scenario.duration).velocity
    if isinstance(current, Waves):
        depth = scenario.tank.depth if current.depth is None else current.depth
        return sea_numbers(current, depth, generator(scenario.seed, f"waves {place}"))
    values = dataclasses.asdict(current)
    return np.array([values[name] for name in CURRENTS[current.kind].parameters])
