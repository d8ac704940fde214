"""A plume against the closed forms of diffusion and advection."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.reading.yaml_file import parse_yaml
from cocorosim_ros.world.checks.loading import read_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.water.flow import make_flow
from cocorosim_ros.world.water.plume import Puffs, carry, concentration_at, no_puffs, release

NOTHING = np.zeros((0, 4)), np.zeros((0, 6))
OCEAN = Tank(np.array([-500.0, -500.0, -500.0]), np.array([500.0, 500.0, 0.0]), *NOTHING)
BOX = Tank(np.array([-1.0, -0.5, -1.0]), np.array([1.0, 0.5, 0.0]), *NOTHING)


def one_puff(place: Any, size: float = 0.1, mass: float = 2.0) -> Puffs:
    """A single cloud."""
    return release(no_puffs(), np.array(place, dtype=float), size, mass)


def drift(puffs: Puffs, flow: Any, tank: Tank, steps: int, diffusivity: float) -> Puffs:
    """The cloud after some steps of 0.5 s."""
    for step in range(steps):
        carry(puffs, flow, tank, Interval(0.5 * step, 0.5), diffusivity)
    return puffs


@pytest.mark.parametrize("velocity", [(0.0, 0.0), (0.05, -0.03)])
def test_gaussian_of_the_textbook(velocity: tuple[float, float]) -> None:
    """After t: m (2 pi s2)^-3/2 exp(-r^2 / 2 s2), s2 = s0^2 + 2 D t, around the source moved by V t."""
    puffs = drift(one_puff([0, 0, -250]), make_flow([("uniform", np.array(velocity))]), OCEAN, 200, 2e-4)
    variance = 0.01 + 2 * 2e-4 * 100.0
    for offset in np.random.default_rng(1).normal(0.0, 0.2, (20, 3)):
        place = np.array([100 * velocity[0], 100 * velocity[1], -250.0]) + offset
        expected = 2.0 * (2 * math.pi * variance) ** -1.5 * math.exp(-offset @ offset / (2 * variance))
        assert concentration_at(place, puffs, OCEAN) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("size", [0.1, 0.6, 3.0])
def test_walls_keep_all_of_it(size: float) -> None:
    """In a tank of 2 x 1 x 1 m the concentration integrates to the mass, wherever the cloud is and however large."""
    puffs = one_puff([0.9, -0.45, -0.1], size)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    total = 0.0
    for x, wx in zip(nodes, weights, strict=True):
        for y, wy in zip(nodes, weights, strict=True):
            for z, wz in zip(nodes, weights, strict=True):
                place = np.array([x, 0.5 * y, 0.5 * z - 0.5])
                total += 0.25 * wx * wy * wz * concentration_at(place, puffs, BOX)
    assert total == pytest.approx(2.0, rel=1e-6)


def test_in_the_end_it_is_everywhere() -> None:
    """After a long time a closed tank has the same concentration, mass by volume, in every place."""
    puffs = drift(one_puff([0.9, -0.45, -0.1]), np.zeros(0), BOX, 2000, 1e-2)
    for place in np.random.default_rng(2).uniform([-1, -0.5, -1], [1, 0.5, 0], (10, 3)):
        assert concentration_at(place, puffs, BOX) == pytest.approx(2.0 / 2.0, rel=1e-9)


def test_an_eddy_carries_it_round() -> None:
    """A cloud at 0.5 m from a vortex is back after one turn: T = 2 pi r / v(r)."""
    speed = 0.2 / (2 * math.pi * 0.5) * -math.expm1(-0.25 / 0.04)
    turns = 2 * math.pi * 0.5 / speed
    flow = make_flow([("vortex", np.array([0.0, 0.0, 0.2, 0.2]))])
    puffs = one_puff([0.5, 0.0, -5.0])
    for step in range(100):
        carry(puffs, flow, OCEAN, Interval(step * turns / 100, turns / 100), 0.0)
    np.testing.assert_allclose(puffs.centre[0], [0.5, 0.0, -5.0], rtol=0, atol=1e-5)


def test_the_sensor_of_a_scenario() -> None:
    """A steady source in a current: what was released is there, and the robot downstream smells more than the other."""
    text = """
name: leak
description: two Lilys beside a leak
seed: 1
tick: 0.5 s
duration: 60 s
tank: {size: [6 m, 4 m, 2 m]}
integrator: {name: rk4, step: 0.25 s}
water:
  currents: [{kind: uniform, x: 0.03 m/s, y: 0 m/s}]
  plume: {source: [-1 m, 0 m, -1 m], rate: 2 mg/s, diffusivity: 1 cm^2/s, interval: 1 s}
swarm:
  - platform: lily
    controller: idle
    start: {poses: [[-0.5 m, 0 m, -1 m, 0 deg], [-1.5 m, 0 m, -1 m, 0 deg]]}
"""
    scenario = read_scenario(parse_yaml(text, "leak"))
    assert read_scenario(parse_yaml(scenario.to_yaml(), "again")) == scenario
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    for _ in range(40):
        simulation.advance()
    assert simulation.water.puffs.mass.sum() == pytest.approx(20 * 2e-6)
    downstream, upstream = simulation.water.concentration[0]
    assert downstream > 100.0 * upstream >= 0.0
