"""The currents of a scenario on a grid of places in its tank."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.scene.scene import MovingWater
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.world.water.current_numbers import scenario_currents
from cocorosim_ros.world.water.flow import add_water_velocity, make_flow

_PLACES = (8, 8, 3)
"""Arrows along x, y and depth: as many as can be told apart."""
MOST_MOMENTS = 200


def moving_water(scenario: Scenario | None, stamp_ns: Integers) -> MovingWater | None:
    """The water at some of the moments (t,) [ns], which count from the start of the run; None without currents."""
    if scenario is None or scenario.water is None or not scenario.water.currents:
        return None
    flow = make_flow(scenario_currents(scenario))
    places = _places(scenario)
    moments = stamp_ns[:: max(1, -(-stamp_ns.size // MOST_MOMENTS))]
    velocity = np.zeros((moments.size, *places.shape))
    for at, stamp in enumerate(moments):
        for index, place in enumerate(places):
            add_water_velocity(place, float(stamp) / NANOSECONDS, flow, velocity[at, index])
    return MovingWater(moments, places, velocity)


def _places(scenario: Scenario) -> Floats:
    """(p, 3) the middles of equal boxes that fill the tank [m; world]."""
    sides = zip(scenario.tank.lower_corner(), scenario.tank.upper_corner(), _PLACES, strict=True)
    middles = [low + (np.arange(count) + 0.5) * (high - low) / count for low, high, count in sides]
    return np.stack(np.meshgrid(*middles, indexing="ij"), axis=-1).reshape(-1, 3)
