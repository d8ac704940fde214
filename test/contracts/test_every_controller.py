"""What every entry of CONTROLLERS has to keep, unasked."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.controllers import CONTROLLERS
from cocorosim_ros.world.controllers.controller import EXTRA_TOPICS
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, PAYLOAD_LIMIT

BOUNDS = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
INSTRUMENTS = Readings._fields
Make = Callable[..., Any]
SAY_A_DEPTH = {"depth_agreement"}
every_controller = pytest.mark.parametrize("name", CONTROLLERS)


@pytest.fixture
def swarm_of(make_simulation: Make, lily: SimpleNamespace) -> Make:
    """Function of (controller, start): it in the paper's tank, with settings of 0.1 where it is not boids."""

    def make(name: str, start: Any) -> Any:
        count = len(CONTROLLERS[name].settings)
        settings = (*lily.boids, 1.0, 1.0, 1.0)[:count] if name.startswith("boids") else (0.1,) * count
        return make_simulation(start, name, settings, bounds=BOUNDS)

    return make


def answers(simulation: Any, ticks: int, spoil: Callable[[Any, int], None] | None = None) -> Any:
    """Commands (ticks, runs, robots, 3) of a run; `spoil` may change each tick's readings."""
    commands = []
    for tick in range(ticks):
        simulation.sense()
        if spoil:
            spoil(simulation.readings, tick)
        simulation.decide()
        commands.append(simulation.command.copy())
        simulation.advance()
    return np.array(commands)


@every_controller
def test_commands_are_fractions(swarm_of: Make, name: str) -> None:
    """20 robots all over the tank, also in corners and at the surface: every command lies in -1..1."""
    start = np.random.default_rng(4).uniform((-3, -3, -2, -4), (3, 3, 0, 4), (1, 20, 4))
    commands = answers(swarm_of(name, start), 100)
    assert (np.abs(commands) <= 1.0).all()


@every_controller
def test_it_is_deterministic(swarm_of: Make, crowd: Make, name: str) -> None:
    """The same readings get the same answers, to the last bit."""
    once, twice = (answers(swarm_of(name, crowd(1, 6)), 40) for _ in range(2))
    assert np.array_equal(once, twice)


@every_controller
def test_it_survives_being_alone(swarm_of: Make, name: str) -> None:
    """Nobody seen and nobody heard: finite commands all the same."""
    assert np.isfinite(answers(swarm_of(name, [[[0.0, 0.0, -1.0, 0.3]]]), 20)).all()


@every_controller
@pytest.mark.parametrize("instrument", INSTRUMENTS)
@pytest.mark.parametrize("period", [1, 3])
def test_it_survives_a_failing_instrument(swarm_of: Make, crowd: Make, name: str, instrument: str, period: int) -> None:
    """An instrument that shows NaN, always or in every third tick: every command still lies in -1..1."""

    def spoil(readings: Any, tick: int) -> None:
        if tick % period == 0:
            getattr(readings, instrument)[...] = math.nan

    start = crowd(1, 6)
    start[0, :2, 0] = 2.85  # two at a wall
    start[0, 2:4, 2] = -0.3, -1.9  # one near the surface, one near the floor
    simulation = swarm_of(name, start)
    commands = answers(simulation, 30, spoil)
    assert (np.abs(commands) <= 1.0).all()
    assert np.isfinite(simulation.said).all()


@every_controller
def test_it_survives_dropouts_with_little_to_go_by(swarm_of: Make, crowd: Make, name: str) -> None:
    """Without gyro and velocity, and with compass and pressure in every other tick: no command is NaN."""

    def spoil(readings: Any, tick: int) -> None:
        readings.angular_rate[...] = math.nan
        readings.velocity[...] = math.nan
        if tick % 2:
            readings.compass[...] = math.nan
            readings.pressure[...] = math.nan

    assert (np.abs(answers(swarm_of(name, crowd(1, 6)), 20, spoil)) <= 1.0).all()


@every_controller
def test_it_survives_total_blindness_and_recovers(swarm_of: Make, crowd: Make, name: str) -> None:
    """All instruments NaN for ten ticks in the middle: no command is NaN, then or later."""

    def spoil(readings: Any, tick: int) -> None:
        if 10 <= tick < 20:
            for reading in readings:
                reading[...] = math.nan

    assert (np.abs(answers(swarm_of(name, crowd(1, 6)), 40, spoil)) <= 1.0).all()


@every_controller
def test_a_message_has_the_length_announced(swarm_of: Make, crowd: Make, name: str) -> None:
    """What is said has `payload_length` numbers, and controllers without payload are silent."""
    simulation = swarm_of(name, crowd(1, 6))
    answers(simulation, 10)
    announced = CONTROLLERS[name].payload_length
    assert 0 <= announced <= PAYLOAD_LIMIT
    assert (simulation.said[..., MESSAGE_LENGTH] == announced).all()


@pytest.mark.parametrize("name", sorted(set(CONTROLLERS) - SAY_A_DEPTH))
def test_without_a_velocity_none_is_said(swarm_of: Make, crowd: Make, name: str) -> None:
    """Without a velocity estimate nothing is said by controllers that would say it."""
    simulation = swarm_of(name, crowd(1, 6))
    simulation.world.instruments.measured[:, list(SENSORS).index("velocity")] = False
    answers(simulation, 10)
    assert not simulation.said[..., MESSAGE_LENGTH].any()


@every_controller
def test_it_takes_its_arguments_by_the_protocol(name: str) -> None:
    """decide and speak take what controllers.controller promises; summary and settings are told."""
    controller = CONTROLLERS[name]
    decide = inspect.signature(controller.decide.py_func)
    speak = inspect.signature(controller.speak.py_func)
    assert list(decide.parameters) == ["observation", "sensor_axis", "settings", "request"]
    assert set(controller.needs) <= set(EXTRA_TOPICS)
    assert list(speak.parameters) == ["observation", "settings", "message"]
    assert controller.summary
    assert len(set(controller.settings)) == len(controller.settings)
