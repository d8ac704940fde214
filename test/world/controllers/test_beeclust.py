"""BEECLUST: when it stops, how long, and what it does then."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.world.controllers.request import DIVE, HEADING, SPEED

LEFT, RIGHT, BACK, UP, DOWN = range(5)
# meeting range, longest wait, half light, parting time, speed, depth, gain
SETTINGS = (0.3, 60.0, 500.0, 10.0, 0.25, 1.2, 3.0)
GOLDEN = math.pi * (3.0 - math.sqrt(5.0))
Make = Callable[..., Any]


def test_it_swims_straight_at_its_depth(decide_once: Make) -> None:
    """Nobody near: the speed and depth of the settings, no turn."""
    request = decide_once("beeclust", SETTINGS, ranges={LEFT: 0.31, UP: 0.1}, illuminance=500.0, time=3.0)
    assert (request[SPEED], request[DIVE]) == (0.25, 1.2)
    assert math.isnan(request[HEADING])


@pytest.mark.parametrize(("light", "wait"), [(500.0, 30.0), (1000.0, 48.0), (0.0, 0.0), (math.nan, 0.0)])
def test_it_waits_as_long_as_it_is_bright(decide_once: Make, light: float, wait: float) -> None:
    """60 s E^2 / (E^2 + 500^2): 30 s at 500 lx, 48 s at 1000 lx, none in the dark."""
    request = decide_once("beeclust", SETTINGS, ranges={RIGHT: 0.2}, illuminance=light, time=7.0)
    assert request[SPEED] == (0.0 if wait else 0.25)
    if wait:
        assert decide_once("beeclust", SETTINGS, request.copy(), time=6.9 + wait, illuminance=light)[SPEED] == 0.0
    after = decide_once("beeclust", SETTINGS, request.copy(), time=7.0 + wait, illuminance=light)
    assert after[SPEED] == 0.25


def test_after_waiting_it_turns_and_parts(decide_once: Make) -> None:
    """The n-th turn is n golden angles from the compass; for 10 s nobody is met, then somebody is."""
    request = decide_once("beeclust", SETTINGS, ranges={RIGHT: 0.2}, illuminance=500.0, time=0.0)
    request = decide_once("beeclust", SETTINGS, request, ranges={RIGHT: 0.2}, illuminance=500.0, time=30.0, compass=0.2)
    assert request[HEADING] == pytest.approx(0.2 + GOLDEN)
    request = decide_once("beeclust", SETTINGS, request, ranges={RIGHT: 0.2}, illuminance=500.0, time=39.5)
    assert request[SPEED] == 0.25
    request = decide_once("beeclust", SETTINGS, request, ranges={RIGHT: 0.2}, illuminance=500.0, time=40.0)
    assert request[SPEED] == 0.0
    request = decide_once("beeclust", SETTINGS, request, illuminance=500.0, time=70.0, compass=0.0)
    assert request[HEADING] == pytest.approx(2.0 * GOLDEN - 2.0 * math.pi)


def test_robots_gather_at_the_lamp() -> None:
    """In the second quarter hour at least half as many again are within 1 m of the lamp as in the dark."""
    import numpy as np

    from cocorosim_ros.world.checks.loading import load_scenario
    from cocorosim_ros.world.seeding.seeding import start_poses
    from cocorosim_ros.world.surroundings.lamps import darkness
    from cocorosim_ros.world.tick.assembly import build_world
    from cocorosim_ros.world.tick.simulation import Simulation

    scenario = load_scenario("light_gathering")
    runs = 16
    start = np.array([start_poses(scenario, run) for run in range(runs)])
    world = build_world(scenario, runs)
    lamp = np.array(scenario.light.lamps[0].position)

    def share_at_the_lamp(lamps: Any) -> float:
        simulation = Simulation(replace(world, lamps=lamps), start)
        share = 0.0
        for tick in range(scenario.ticks):
            simulation.sense()
            simulation.decide()
            simulation.advance()
            if tick >= scenario.ticks // 2:
                share += (np.linalg.norm(simulation.state[..., :3] - lamp, axis=-1) < 1.0).mean()
        return float(share / (scenario.ticks // 2))

    assert share_at_the_lamp(world.lamps) > 1.5 * share_at_the_lamp(darkness())
