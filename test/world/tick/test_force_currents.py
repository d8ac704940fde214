"""The paper's force currents in whole simulations: order of a tick, seeds, batches, wakes on oneself."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario, read_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.vehicle_model.vehicles import PATCH_FORCE_COLUMNS

SMALL = """
name: small
description: two Lilys in a small turbulent tank
seed: 5
tick: {tick}
duration: 30 s
tank: {{size: [2 m, 2 m, 1 m]}}
integrator: {{name: semi_implicit_euler, step: {tick}, contact: stop_position}}
water:
  force_currents:
    cold_spots: {{force: 0.005 N, probability: 0.01}}
    wakes: {{strength: {wakes}}}
swarm:
  - platform: lily
    count: 2
    controller: boids_blt
    start: {{box: {{centre: [0 m, 0 m, -0.5 m], size: [1 m, 1 m, 0.5 m]}}}}
"""


def small(tick: str = "0.5 s", wakes: float = 1.0) -> Scenario:
    """Two Lilys in a small turbulent tank."""
    return read_scenario(parse_yaml(SMALL.format(tick=tick, wakes=wakes), "small"))


def simulated(scenario: Scenario, runs: int = 1, first_run: int = 0, ticks: int = 40) -> Simulation:
    """Some runs of a scenario after some ticks."""
    start = np.stack([start_poses(scenario, run) for run in range(first_run, first_run + runs)])
    simulation = Simulation(build_world(scenario, runs, first_run), start)
    for _ in range(ticks):
        simulation.sense()
        simulation.decide()
        simulation.advance()
    return simulation


def test_a_batch_is_its_single_runs() -> None:
    """Three runs at once are bit for bit each by itself: robots, water and what acts on them."""
    together = simulated(small(), runs=3)
    for run in range(3):
        alone = simulated(small(), first_run=run)
        assert np.array_equal(alone.state[0], together.state[run])
        assert np.array_equal(alone.water.fields[0].field, together.water.fields[run].field)
        assert np.array_equal(alone.water.vehicles.parameters[0], together.water.vehicles.parameters[run])
    assert not np.array_equal(together.state[0], together.state[1])


def test_the_same_seed_twice() -> None:
    """The same scenario gives the same run to the last bit, and the world it is made of stays as it was."""
    world, start = build_world(small()), start_poses(small())[None]
    before = world.vehicles.parameters.copy()
    ends = []
    for _ in range(2):
        simulation = Simulation(world, start)
        for _ in range(20):
            simulation.advance()
        ends.append(simulation.state)
    assert np.array_equal(*ends) and ends[0][0, 0, 4] != 0.0
    assert np.array_equal(world.vehicles.parameters, before)


def test_cold_spots_do_not_depend_on_the_robots() -> None:
    """Without wakes the water of a run is the same whatever swims in it."""
    still = simulated(small(wakes=0.0), ticks=10)
    start = start_poses(small())[None] + [0.3, 0.0, 0.0, 1.0]
    other = Simulation(build_world(small(wakes=0.0)), start)
    for _ in range(10):
        other.advance()
    assert np.array_equal(still.water.fields[0].field, other.water.fields[0].field)


def test_the_steps_of_the_water_keep_their_length() -> None:
    """With ticks of 0.1 s the water still takes one step every 0.5 s, and the same ones."""
    coarse = simulated(small(wakes=0.0), ticks=10)
    fine = simulated(small("0.1 s", wakes=0.0), ticks=50)
    assert fine.water.fields[0].step == coarse.water.fields[0].step == 10
    assert np.array_equal(fine.water.fields[0].field, coarse.water.fields[0].field)


def test_the_force_of_a_tick_acts_in_the_next() -> None:
    """A robot at rest is accelerated by the force of its patch after the first tick; semi-implicit: v = F dt / m."""
    simulation = simulated(small(wakes=0.0), ticks=0)
    water = simulation.water.fields[0]
    simulation.advance()
    assert not simulation.state[..., 4:8].any()
    water.field[...] = 0.002
    water.push(simulation.state[0], simulation.water._push[0])
    simulation.water.vehicles.parameters[0][:, PATCH_FORCE_COLUMNS] = simulation.water._push[0]
    simulation.advance()
    cosine, sine = np.cos(simulation.state[0, :, 3]), np.sin(simulation.state[0, :, 3])
    east = simulation.state[0, :, 4] * cosine - simulation.state[0, :, 5] * sine
    np.testing.assert_allclose(east, 0.002 * 0.5 / 0.44, rtol=1e-12)
    np.testing.assert_allclose(simulation.state[0, :, 6], 0.002 * 0.5 / 0.44, rtol=1e-12)


def lone_swimmer(strength: float, diffusion: str) -> Any:
    """Mean speed of one Lily at 10 % thrust in the last 20 s of 3 min at a fixed heading, with its own wake alone."""
    text = f"""
name: lone
description: one Lily and its wake
seed: 1
tick: 0.5 s
duration: 200 s
tank: {{size: [12 m, 2 m, 1 m]}}
integrator: {{name: semi_implicit_euler, step: 0.5 s, contact: stop_position}}
water: {{force_currents: {{diffusion: {diffusion}, torque_lever: 0 m, wakes: {{strength: {strength}}}}}}}
swarm:
  - platform: lily_paper
    controller: constant
    overrides: {{first: 0.1, second: 0.1, third: 0}}
    start: {{poses: [[-5.55 m, 0.05 m, -0.55 m, 0 deg]]}}
"""
    simulation = simulated(read_scenario(parse_yaml(text, "lone")), ticks=0)
    track = []
    for _ in range(360):
        simulation.sense()
        simulation.decide()
        simulation.advance()
        track.append(simulation.state[0, 0, :3].copy())
    assert abs(track[-1][1] - 0.05) < 1e-6
    return (track[-1][0] - track[-41][0]) / 20.0


@pytest.mark.parametrize("diffusion", ["paper_equation_5", "released"])
def test_a_wake_slows_its_maker_a_little(diffusion: str) -> None:
    """With the thrusters' own force a Lily loses 0 to 12 % of its speed; with fifty times that most of it."""
    still = lone_swimmer(0.0, diffusion)
    assert still == pytest.approx(0.0237, abs=1e-4)
    assert 0.88 * still < lone_swimmer(1.0, diffusion) < still
    assert lone_swimmer(50.0, diffusion) < still / 3


@pytest.mark.parametrize("name", ["turbulence_T0", "turbulence_T5e-4", "turbulence_T5e-3"])
def test_the_paper_s_turbulence_is_stable(name: str) -> None:
    """With its wakes on, which made the original diverge within 12 ticks, 400 ticks stay finite and bounded."""
    simulation = simulated(load_scenario(name), ticks=400)
    size = {"turbulence_T0": 0.0, "turbulence_T5e-4": 5e-4, "turbulence_T5e-3": 5e-3}[name]
    assert np.isfinite(simulation.state).all()
    # Steady gain 7.7 of the wakes' 0.005 N and of at most a few spots in one place.
    assert 0.0 < np.abs(simulation.water.fields[0].field).max() < 8.0 * (0.01 + 5.0 * size)
