"""How far the search for neighbours has to look."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest


@pytest.mark.parametrize(("controller", "reach"), [("boids_vanilla", 0.5), ("boids_blt", 0.2)])
def test_exact_neighbours_are_looked_for_beyond_blind_sensors(controller: str, reach: float) -> None:
    """Sensors and radio of 0.2 m: who knows neighbours exactly is still to know all within 0.5 m."""
    from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario
    from cocorosim_ros.world.tick.assembly import build_world

    text = load_scenario("eleven_lilys").to_yaml().replace("behaviour: boids_blt", f"behaviour: {controller}")
    world = build_world(parse_scenario(text, "x"))
    short = world.instruments._replace(neighbour_range=np.full_like(world.instruments.neighbour_range, 0.2))
    world = dataclasses.replace(world, instruments=short, radio_range=np.full(11, 0.2))
    assert world.reach == reach
