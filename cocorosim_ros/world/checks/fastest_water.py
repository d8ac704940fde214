"""How fast the water of a scenario gets at most, as far as its currents are velocities."""

from __future__ import annotations

from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.water.current_numbers import scenario_currents
from cocorosim_ros.world.water.currents import CURRENTS


def fastest_water(scenario: Scenario) -> float:
    """The sum of the fastest speeds [m/s] of all currents in the tank; 0 in still water. Forces on patches are none."""
    currents = scenario_currents(scenario)
    return sum(CURRENTS[name].fastest(numbers, scenario.tank.size) for name, numbers in currents)
