"""The body by which the paper chose its currents drifts as one expects."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation


def test_floaters_wander() -> None:
    """They keep moving at a few cm/s, wind about, spread with time and stay in the water: neither stuck nor flung."""
    scenario = load_scenario("floaters")
    simulation = Simulation(build_world(scenario), start_poses(scenario)[None])
    places, speeds = [simulation.state[0, :, :3].copy()], []
    for _ in range(scenario.ticks):
        simulation.advance()
        places.append(simulation.state[0, :, :3].copy())
        speeds.append(np.linalg.norm(simulation.state[0, :, 4:7], axis=1))
    track = np.array(places)
    speed = np.sqrt(np.mean(np.square(speeds[20:])))
    assert 0.01 < speed < 0.1
    path = np.linalg.norm(np.diff(track, axis=0), axis=2).sum(axis=0)
    away = np.linalg.norm(track[-1] - track[0], axis=1)
    assert (path > 3.0 * away).all() and away.mean() > 0.3
    assert np.linalg.norm(np.diff(track, axis=0), axis=2).max() < 0.1
    assert (np.abs(track) <= [2.5, 2.5, 2.0]).all() and track[..., 2].max() <= 0.0
