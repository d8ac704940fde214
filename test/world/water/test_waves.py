"""Waves: spectrum, dispersion, decay with depth, and the pressure that belongs to the velocity."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.waves import Waves
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.checks.loading import load_scenario, parse_scenario
from cocorosim_ros.world.seeding.seeding import generator, start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation
from cocorosim_ros.world.water.currents.waves import SIZE, wave_head, waves
from cocorosim_ros.world.water.sea_state import sea_numbers, spectrum, wave_numbers

GRAVITY = 9.81


def velocity(numbers: Any, place: Any, time: float) -> Any:
    """Of the water (3,) [m/s]."""
    total = np.zeros(3)
    waves(np.asarray(place, dtype=float), time, numbers, total)
    return total


def one(depth: float, period: float = 8.0, amplitude: float = 0.5, heading: float = 0.0) -> Any:
    """A single wave."""
    omega = 2.0 * math.pi / period
    k = float(wave_numbers(np.array([omega]), depth)[0])
    return np.array([depth, amplitude, omega, k, k * math.cos(heading), k * math.sin(heading), 0.4])


def test_deep_and_shallow_water() -> None:
    """In deep water the length is g T^2 / (2 pi), in shallow water the speed sqrt(g h); between, the equation holds."""
    omega = 2.0 * math.pi / np.array([2.0, 5.0, 8.0, 15.0])
    np.testing.assert_allclose(wave_numbers(omega, 5000.0), omega**2 / GRAVITY, rtol=1e-14)
    slow = 2.0 * math.pi / np.array([300.0, 3000.0])
    np.testing.assert_allclose(slow / wave_numbers(slow, 2.0), math.sqrt(GRAVITY * 2.0), rtol=2e-4)
    for depth in (0.5, 3.0, 20.0):
        k = wave_numbers(omega, depth)
        np.testing.assert_allclose(GRAVITY * k * np.tanh(k * depth), omega**2, rtol=1e-13)


def test_velocity_decays_with_depth() -> None:
    """In deep water as exp(-k depth), on circles; at the floor of shallow water nothing goes up or down."""
    deep = one(5000.0)
    k = deep[3]
    for depth in (0.0, 3.0, 20.0):
        for time in (0.0, 1.3, 2.9):
            speed = np.linalg.norm(velocity(deep, (4.0, 1.0, -depth), time))
            assert speed == pytest.approx(0.5 * deep[2] * math.exp(-k * depth), rel=1e-12)
    shallow = one(3.0)
    assert abs(velocity(shallow, (1.0, 0.0, -3.0), 0.7)[2]) < 1e-15
    assert abs(velocity(shallow, (1.0, 0.0, -3.0), 0.7)[0]) > 0.1


@pytest.mark.parametrize(("depth", "heading"), [(4.0, 0.0), (30.0, 2.1)])
def test_pressure_accelerates_the_water(depth: float, heading: float) -> None:
    """Euler's equation of small waves: du/dt = -g d(head)/dx along all three axes, by central differences."""
    numbers, place, step = one(depth, heading=heading), np.array([2.0, -1.0, -1.5]), 1e-4
    for time in (0.2, 3.0):
        accelerated = (velocity(numbers, place, time + step) - velocity(numbers, place, time - step)) / (2.0 * step)
        for axis, away in enumerate(step * np.eye(3)):
            slope = (wave_head(place + away, time, numbers) - wave_head(place - away, time, numbers)) / (2.0 * step)
            assert accelerated[axis] == pytest.approx(-GRAVITY * slope, abs=1e-7)


def test_significant_height() -> None:
    """Four standard deviations of the surface, over three hours at one place, are the height that was asked for."""
    sea = sea_numbers(Waves(1.5, 6.0), 50.0, generator(1, "waves 0"))
    rows = sea[1:].reshape(-1, SIZE)
    assert 4.0 * math.sqrt((rows[:, 0] ** 2).sum() / 2.0) == pytest.approx(1.5, rel=1e-12)
    surface = [wave_head(np.array([3.0, 2.0, 0.0]), time, sea) for time in np.arange(0.0, 10_800.0, 0.5)]
    assert 4.0 * np.std(surface) == pytest.approx(1.5, rel=0.02)
    assert not np.array_equal(sea, sea_numbers(Waves(1.5, 6.0), 50.0, generator(2, "waves 0")))


def test_spectrum() -> None:
    """Its peak stands at the peak's frequency, gamma times as high as without; far above it falls as omega^-5."""
    omega = np.linspace(0.3, 8.0, 20_001)
    sharp, flat = (spectrum(omega, 1.0, gamma) for gamma in (3.3, 1.0))
    assert omega[np.argmax(sharp)] == pytest.approx(1.0, abs=1e-3)
    at_peak = [float(spectrum(np.array([1.0]), 1.0, gamma)[0]) for gamma in (3.3, 1.0)]
    assert at_peak[0] / at_peak[1] == pytest.approx(3.3, rel=1e-12)
    assert sharp[-1] / flat[-1] == pytest.approx(1.0, rel=1e-12)
    far = spectrum(np.array([20.0, 40.0]), 1.0, 3.3)
    assert far[0] / far[1] == pytest.approx(32.0, rel=1e-4)


HEAD = """
name: at_sea
description: one Lily below waves
seed: 4
tick: 0.5 s
duration: 60 s
tank: {size: [50 m, 50 m, 10 m]}
integrator: {name: rk4, step: 0.05 s}
swarm:
  - {platform: lily, controller: idle, start: {poses: [[3 m, 0 m, -2 m, 0 deg]]}}
water: {currents: [{kind: waves, height: %s, period: 4 s, direction: 90 deg}]}
"""


def scenario_of(folder: Path, height: str) -> Scenario:
    """A scenario with waves of this height."""
    (folder / "at_sea.yaml").write_text(HEAD % height)
    return load_scenario(folder / "at_sea.yaml")


def test_a_robot_swings_and_its_pressure_sensor_feels_it(tmp_path: Path) -> None:
    """What the sensor shows is depth and the head of the waves there; the robot goes along the waves, not across."""
    scenario = scenario_of(tmp_path, "20 cm")
    assert parse_scenario(scenario.to_yaml(), scenario.origin) == scenario
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    sea = sea_numbers(Waves(0.2, 4.0, math.pi / 2.0), 10.0, generator(4, "waves 0"))
    felt, went = [], []
    for tick in range(120):
        row = simulation.state[0, 0].copy()
        shown = simulation.sense().pressure[0, 0]
        head = wave_head(row[:3], tick * 0.5, sea)
        assert shown == pytest.approx(101325.0 - 9810.0 * row[2] + 9810.0 * head, abs=1e-6)
        felt.append(head)
        went.append(row[:2])
        simulation.advance()
    assert max(felt) - min(felt) > 0.05
    assert np.ptp(np.array(went)[:, 1]) > 0.02
    assert np.ptp(np.array(went)[:, 0]) < 1e-9


def test_waves_that_would_break(tmp_path: Path) -> None:
    """Higher than 0.142 of their length: a sentence; waves of 4 s in 10 m of water are 24 m long."""
    with pytest.raises(CocorosimError, match=r"'water.currents\[0\].height' has '4 m', but waves of 4 s in 10 m"):
        scenario_of(tmp_path, "4 m")
