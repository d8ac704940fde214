"""The functions of the operating system, carried out by a Lily."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.controllers import functions
from cocorosim_ros.world.controllers.request import DIRECT, FRACTIONS, HEADING, REQUEST_SIZE, TURN_GAIN

Make = Callable[..., Any]


@pytest.fixture
def carried_out(make_simulation: Make) -> Make:
    """Function of (function, arguments, seconds, start depth): the Lily's state after its request was kept so long."""
    from cocorosim_ros.world.controllers.operating_system import dive, steer
    from cocorosim_ros.world.motion.motion import apply_commands, move
    from cocorosim_ros.world.tick.deciding import observe

    def carry(ask: Callable[[Any, float], None], seconds: float) -> Any:
        simulation = make_simulation([[[0.0, 0.0, -5.0, 1.0]]])
        request = np.zeros(REQUEST_SIZE)
        request[HEADING] = 1.0
        ask(request, 1.0)
        crew, world = simulation.world.crew, simulation.world
        for _ in range(round(seconds / 0.5)):
            simulation.sense()
            observation = observe.py_func(simulation.time_ns * 1e-9, simulation.perception, 0, 0, np.zeros(3))
            command = simulation.command[0, 0]
            command[:] = request[FRACTIONS : FRACTIONS + 3]
            if request[DIRECT] == 0.0:
                steer(observation, crew.system[0], request, crew.actuator[0], command)
                dive(observation, observation.velocity[2], crew.system[0], request, crew.actuator[0], command)
            apply_commands(simulation.state, simulation.command, world.vehicles)
            move(simulation.state, world.vehicles, world.tank, world.stepping, world.water.flow, 0.0)
            simulation.tick += 1
        return simulation.state[0, 0]

    return carry


def test_absolute_heading(carried_out: Make) -> None:
    """Asked for -100 degrees it looks there a minute later, within a degree."""
    wanted = math.radians(-100.0)

    def ask(request: Any, compass: float) -> None:
        functions.set_absolute_heading(request, wanted)
        request[TURN_GAIN] = 3.0

    state = carried_out(ask, 60.0)
    assert math.remainder(state[3] - wanted, 2.0 * math.pi) == pytest.approx(0.0, abs=math.radians(1.0))


def test_relative_heading(carried_out: Make) -> None:
    """From 1 rad, asked to turn by 2.5 rad to the left: 3.5 rad a minute later, the shorter way."""

    def ask(request: Any, compass: float) -> None:
        functions.set_relative_heading(request, compass, 2.5)
        request[TURN_GAIN] = 3.0

    assert carried_out(ask, 60.0)[3] == pytest.approx(3.5, abs=math.radians(1.0))


def test_relative_heading_without_compass_asks_for_nothing() -> None:
    """NaN from the compass leaves the heading asked for as it was."""
    request = np.zeros(REQUEST_SIZE)
    request[HEADING] = 0.7
    functions.set_relative_heading(request, math.nan, 1.0)
    assert request[HEADING] == 0.7


def test_speed(carried_out: Make) -> None:
    """A quarter of the thrust ends at half the terminal speed, 0.0375 m/s (less 0.2 % of the command scale)."""

    def ask(request: Any, compass: float) -> None:
        functions.set_speed(request, 0.25)
        request[TURN_GAIN] = 3.0

    assert carried_out(ask, 120.0)[4] == pytest.approx(0.0375 * math.sqrt(127.0 / 127.5), rel=1e-4)


def test_speed_backwards(carried_out: Make) -> None:
    """A quarter of the thrust backwards, the heading kept: half the terminal speed, tail first."""

    def ask(request: Any, compass: float) -> None:
        functions.set_speed(request, -0.25)
        request[TURN_GAIN] = 3.0

    row = carried_out(ask, 120.0)
    assert row[4] == pytest.approx(-0.0375 * math.sqrt(127.0 / 127.5), rel=1e-4)
    assert row[3] == pytest.approx(1.0, abs=math.radians(1.0))


def test_depth(carried_out: Make) -> None:
    """From 5 m to 4.5 m at 5 cm/s: there after 30 s, within a centimetre."""
    assert carried_out(lambda request, _: functions.set_depth(request, 4.5), 30.0)[2] == pytest.approx(-4.5, abs=0.01)


def test_dive_speed(carried_out: Make) -> None:
    """Asked to sink with 2 cm/s it does, within the controller's 4 % (a P controller against drag)."""
    assert carried_out(lambda request, _: functions.set_dive_speed(request, -0.02), 20.0)[6] == pytest.approx(
        -0.02, rel=0.05
    )


def test_direct_actuators(carried_out: Make) -> None:
    """Left at -1, right at +1: it turns on the spot with 1.48 rad/s; beyond 1 is cut."""

    def ask(request: Any, compass: float) -> None:
        functions.set_actuator(request, 0, -1.0)
        functions.set_actuator(request, 1, 7.0)

    state = carried_out(ask, 30.0)
    assert state[7] == pytest.approx(1.48, rel=1e-3)
    assert np.hypot(state[0], state[1]) == pytest.approx(0.0, abs=1e-12)


def test_heading_achieved() -> None:
    """Within the tolerance across the cut at pi, and not beyond it."""
    request = np.zeros(REQUEST_SIZE)
    request[HEADING] = math.pi - 0.05
    assert functions.heading_achieved(request, -math.pi + 0.04, 0.1)
    assert not functions.heading_achieved(request, -math.pi + 0.06, 0.1)


def test_neighbours_by_blue_light_and_radio() -> None:
    """Two of five sensors see somebody, three messages came in."""
    from cocorosim_ros.world.state.observation import blank_observation

    observation = blank_observation(5, 4)._replace(heard_count=3)
    observation.neighbour_range[[1, 4]] = 0.3
    assert functions.neighbours_in_sight(observation) == 2
    assert functions.neighbours_on_radio(observation) == 3
