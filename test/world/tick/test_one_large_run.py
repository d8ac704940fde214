"""One large run, whose robots are gone through in threads."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.world.checks.loading import read_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS

CROWD = """
name: crowd
description: a crowd of two kinds, some of whom feel the wakes of others
seed: 3
tick: 0.5 s
duration: 30 s
tank: {size: [8 m, 8 m, 2 m]}
integrator: {name: rk4, step: 0.25 s, contact: inelastic}
swarm:
  - platform: lily
    count: 97
    prefix: lily
    controller: boids_blt
    start: {box: {centre: [0 m, 0 m, -1.2 m], size: [7 m, 7 m, 1.2 m]}}
  - platform: lily_paper
    count: 53
    prefix: other
    controller: boids_vanilla
    start: {box: {centre: [0 m, 0 m, -1.2 m], size: [7 m, 7 m, 1.2 m]}}
"""


def simulated(wakes: float = 0.0) -> Simulation:
    """The crowd after some ticks, its first robots feeling the wakes of all others so much."""
    scenario = read_scenario(parse_yaml(CROWD, "crowd"))
    world = build_world(scenario)
    if wakes > 0.0:
        world.vehicles.active[:, :60] |= EFFECT_BIT["neighbour_wake"]
        world.vehicles.parameters[:, :60, PARAMETER_COLUMNS["neighbour_wake.gain"]] = wakes
    simulation = Simulation(world, start_poses(scenario)[None])
    for _ in range(25):
        simulation.sense()
        simulation.decide()
        simulation.advance()
    return simulation


@pytest.mark.parametrize("at_a_time", [7, 24, 149])
@pytest.mark.parametrize("wakes", [0.0, 0.5])
def test_threads_change_nothing(wakes: float, at_a_time: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the parts: states, readings, messages and memories are the same to the last bit."""
    alone = simulated(wakes)
    monkeypatch.setattr("cocorosim_ros.world.tick.simulation.ROBOTS_FOR_THREADS", 100)
    monkeypatch.setattr("cocorosim_ros.world.tick.simulation.ROBOTS_OF_A_PART", at_a_time)
    monkeypatch.setattr("cocorosim_ros.foundation.side_by_side.processors", lambda: 3)
    together = simulated(wakes)
    assert alone.inbox.heard.sum() > 100  # they have something to do with each other
    assert wakes == 0.0 or not np.array_equal(alone.state, simulated().state)
    for one, other in zip(
        (alone.state, alone.memory, alone.said, alone.inbox.message, alone.nearest, *alone.readings),
        (together.state, together.memory, together.said, together.inbox.message, together.nearest, *together.readings),
        strict=True,
    ):
        assert np.array_equal(one, other, equal_nan=True)


def test_lists_that_outgrow_their_room_in_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    """More neighbours than a list had room for at first are all found by several threads."""
    monkeypatch.setattr("cocorosim_ros.world.surroundings.neighbours.FIRST_CAPACITY", 1)
    alone = simulated()
    monkeypatch.setattr("cocorosim_ros.world.tick.simulation.ROBOTS_FOR_THREADS", 100)
    monkeypatch.setattr("cocorosim_ros.world.tick.simulation.ROBOTS_OF_A_PART", 40)
    monkeypatch.setattr("cocorosim_ros.foundation.side_by_side.processors", lambda: 2)
    assert np.array_equal(alone.state, simulated().state)
