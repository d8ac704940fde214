"""Eleven robots on one acoustic channel: in slots everybody hears everybody, all at once nobody hears anything."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from cocorosim_ros.scenario.parts.acoustic import Acoustic
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.state.state import Z
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

ROBOTS = 11
TICKS = 440  # 220 s, forty rounds


def swum(runs: int, **acoustic: Any) -> tuple[Simulation, np.ndarray[Any, Any], int]:
    """A simulation after its ticks; how often each robot (receivers, senders) heard each; how much was garbled."""
    scenario = load_scenario("acoustic_slots")
    assert isinstance(scenario.acoustic, Acoustic)
    scenario = replace(scenario, acoustic=replace(scenario.acoustic, **acoustic))
    start = np.array([start_poses(scenario, run) for run in range(runs)])
    simulation = Simulation(build_world(scenario, runs), start)
    heard, garbled = np.zeros((ROBOTS, ROBOTS), dtype=int), 0
    for _ in range(TICKS):
        simulation.sense()
        simulation.decide()
        simulation.advance()
        inbox = simulation.sound_inbox
        for robot in range(ROBOTS):
            np.add.at(heard[robot], inbox.sender[0, robot, : inbox.heard[0, robot]], 1)
        assert simulation.garbled is not None
        garbled += int(simulation.garbled.sum())
    return simulation, heard, garbled


def spread(simulation: Simulation) -> float:
    """The standard deviation of the depths of the first run [m]."""
    return float(simulation.state[0, :, Z].std())


def test_in_slots_everybody_hears_everybody_and_agrees() -> None:
    """Forty rounds of eleven slots: each robot hears each other one forty times; nothing is garbled; depths meet."""
    simulation, heard, garbled = swum(1)
    assert np.array_equal(heard, TICKS // ROBOTS * (1 - np.eye(ROBOTS, dtype=int)))
    assert garbled == 0
    assert spread(simulation) < 0.1


def test_all_at_once_nobody_hears_anything() -> None:
    """Everybody sends at every tick: half duplex makes all deaf, and depths stay apart."""
    simulation, heard, _ = swum(1, slot_ns=None)
    assert not heard.any()
    assert spread(simulation) > 0.5


def test_sounds_that_meet_are_garbled() -> None:
    """Two senders and nine that listen: with slots of one tick nothing meets, without slots all of it does."""
    scenario = load_scenario("acoustic_slots")
    for slot, meets in ((500_000_000, False), (None, True)):
        acoustic = replace(scenario.acoustic, slot_ns=slot) if scenario.acoustic else None
        simulation = Simulation(build_world(replace(scenario, acoustic=acoustic)), start_poses(scenario)[None])
        understood, garbled = 0, 0
        for _ in range(2 * ROBOTS):
            simulation.sense()
            simulation.decide()
            simulation.said[0, 2:, 0] = 0.0
            simulation.advance()
            understood += int(simulation.sound_inbox.heard[0, 2:].sum())
            garbled += int(simulation.garbled[0, 2:].sum()) if simulation.garbled is not None else 0
        expected = (0, 2 * 2 * ROBOTS * 9) if meets else (2 * 2 * 9, 0)
        assert (understood, garbled) == expected
