"""A swarm with everything corrupted, in batches and by itself; and the radio without latency."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.controller_file import load_controller
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation


def changed(scenario: Scenario, *replacements: tuple[str, str]) -> Scenario:
    """The scenario with pieces of its text replaced."""
    text = scenario.to_yaml()
    for old, new in replacements:
        assert old in text
        text = text.replace(old, new)
    return parse_scenario(text, "changed")


def swim(scenario: Scenario, runs: range, ticks: int = 60) -> Any:
    """The simulation of some runs of a scenario after some ticks."""
    start = np.array([start_poses(scenario, run) for run in runs])
    simulation = Simulation(build_world(scenario, len(runs), runs.start), start)
    for _ in range(ticks):
        simulation.sense()
        simulation.decide()
        simulation.advance()
    return simulation


@pytest.mark.parametrize("group", ["boids_blt", "boids_vanilla", "boids_blc", "minimal_flocking", "beeclust"])
def test_a_noisy_run_of_a_batch_is_the_run_alone(group: str) -> None:
    """Run 3 of five, with noise on sensors and links, is run 3 by itself, bit for bit."""
    scenario = load_scenario("noisy_lilys")
    if group != "boids_blt":
        swarm = tuple(replace(part, controller=load_controller(group)) for part in scenario.swarm)
        scenario = replace(scenario, swarm=swarm)
    batch, alone = swim(scenario, range(5)), swim(scenario, range(3, 4))
    assert np.array_equal(batch.state[3], alone.state[0])
    assert not np.array_equal(batch.state[2], alone.state[0])


def test_corruption_with_zero_strength_changes_nothing() -> None:
    """Noise of 0, loss and dropout of 0 %, a factor of 1: every state bit for bit as without corruption."""
    clean = load_scenario("eleven_lilys")
    idle = """corruption:
  - {channel: compass, kind: noise, sd: 0 deg}
  - {channel: velocity, kind: dropout, probability: 0}
  - {channel: neighbour_range, kind: range_factor, least: 1, most: 1}
  - {channel: radio, kind: loss, probability: 0}
  - {channel: radio, kind: rate_limit, ticks: 1}
  - {channel: radio, kind: noise, sd: 0}
"""
    same = changed(clean, ("corruption: []\n", idle))
    assert len(same.corruption) == 6
    assert np.array_equal(swim(clean, range(2)).state, swim(same, range(2)).state)


def test_without_latency_words_are_heard_at_once() -> None:
    """After `sense()` of tick k the inbox holds the velocities of tick k, of the robots in range then."""
    scenario = changed(load_scenario("eleven_lilys"), ("latency: one_tick", "latency: none"))
    simulation = swim(scenario, range(1), 20)
    simulation.sense()
    state, inbox = simulation.state[0], simulation.inbox
    assert inbox.heard.sum() > 10
    assert not inbox.age.any()
    for robot in range(11):
        apart = np.linalg.norm(state[:, :3] - state[robot, :3], axis=1)
        senders = [other for other in range(11) if other != robot and apart[other] <= 0.5]
        assert inbox.sender[0, robot, : inbox.heard[0, robot]].tolist() == senders
        for slot, sender in enumerate(senders):
            yaw, surge = state[sender, 3], state[sender, 4]
            east = surge * np.cos(yaw) - state[sender, 5] * np.sin(yaw)
            assert inbox.message[0, robot, slot, 1] == pytest.approx(east, abs=1e-15)


def test_latency_matters() -> None:
    """The same swarm with and without the tick of latency takes different ways."""
    scenario = load_scenario("eleven_lilys")
    instant = changed(scenario, ("latency: one_tick", "latency: none"))
    assert not np.array_equal(swim(scenario, range(1)).state, swim(instant, range(1)).state)
