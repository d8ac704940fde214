"""Commands that act late: a robot of a platform with a delay swims as one whose commands are sent that much later."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.motion.late_commands import LateCommands
from cocorosim_ros.world.state.state import SURGE
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

TICKS = 12


def simulated(platform: Platform, runs: int = 1) -> Simulation:
    """One robot of a platform at rest, in so many runs."""
    scenario = load_scenario("eleven_lilys")
    (group,) = scenario.swarm
    stepping = replace(scenario.integrator, step_ns=scenario.tick_ns // 50)
    scenario = replace(scenario, swarm=(replace(group, platform=platform, count=1),), integrator=stepping)
    start = np.array([[0.0, 0.0, -1.0, 0.3]])
    return Simulation(build_world(scenario, runs=runs), np.tile(start, (runs, 1, 1)))


def late(platform: Platform, seconds: float) -> Platform:
    """The platform with commands that act so much later."""
    numbers = {"delay": Quantity(seconds, "s", dimension_of("s"))}
    return replace(platform, effect_quantities={"command_delay": numbers})


def commands(simulation: Simulation) -> Any:
    """(TICKS, actuators) commands that change at every tick."""
    return np.random.default_rng(4).uniform(-1.0, 1.0, (TICKS, simulation.actuators))


def path(simulation: Simulation, sent: Any) -> Any:
    """(TICKS, runs, columns) states after every tick under the commands sent (TICKS, actuators)."""
    found = []
    for command in sent:
        simulation.sense()
        simulation.command[...] = command
        simulation.advance()
        found.append(simulation.state[:, 0].copy())
    return np.array(found)


@pytest.mark.parametrize("name", ["lily", "bluerov2_heavy"])
def test_it_swims_as_one_that_is_told_later(name: str) -> None:
    """To the bit in two runs, in four and in six degrees of freedom, three ticks later; before that it lies still."""
    platform = load_platform(name)
    plain = simulated(platform, runs=2)
    tick, sent = plain.world.tick_ns * 1e-9, commands(plain)
    shifted = np.concatenate([np.zeros((3, sent.shape[1])), sent[:-3]])
    acted = path(simulated(late(platform, 3.0 * tick), runs=2), sent)
    assert np.array_equal(acted, path(plain, shifted))
    assert not np.array_equal(acted, path(simulated(platform, runs=2), sent))


def test_a_part_of_a_tick_is_a_share_of_the_command() -> None:
    """A step of the thrust that comes a quarter of a tick late acts for three quarters of the first tick."""
    acting = LateCommands(np.array([0.0, 0.25]), 1.0)
    step = np.ones((1, 2, 3))
    first, second = acting.acting(step), acting.acting(step)
    assert np.array_equal(first[0], [[1.0] * 3, [0.75] * 3])
    assert np.array_equal(second, step)


def test_what_is_sent_stays_as_it_is() -> None:
    """The commands that are recorded are those that the controller sent, and only a late robot has others."""
    simulation = simulated(late(load_platform("lily"), 1.0))
    simulation.command[...] = 0.5
    simulation.advance()
    assert (simulation.command == 0.5).all()
    assert simulation.state[0, 0, SURGE] == 0.0
    sent = np.ones((1, 2, 3))
    assert LateCommands(np.zeros(2), 1.0).acting(sent) is sent
