"""One robot with chosen effects, numbers and commands, moved by the simulator's own loop."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

MADE = str(Path(__file__).resolve().parents[2] / "diagnosis" / "made")  # vehicles of several folders
if MADE not in sys.path:
    sys.path.append(MADE)

TANK = ((-50.0, -50.0, -50.0), (50.0, 50.0, 0.0))


@pytest.fixture(scope="session")
def robots(make_vehicles: Callable[..., Any]) -> Callable[..., Any]:
    """Function of (numbers by column, how many): Lilys in one run with the effects that the columns belong to."""
    from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS

    def make(numbers: Mapping[str, float], count: int = 1) -> Any:
        vehicles = make_vehicles(1, count)
        for column, value in numbers.items():
            vehicles.parameters[..., PARAMETER_COLUMNS[column]] = value
            vehicles.active[...] |= EFFECT_BIT.get(column.partition(".")[0], 0)
        return vehicles

    return make


@pytest.fixture(scope="session")
def swim(robots: Callable[..., Any], make_tank: Callable[..., Any]) -> Callable[..., Any]:
    """Function of (numbers, start states, commands per tick, and tick [s], steps, bounds): states after every tick.

    Starts are a dictionary of state columns or one per robot; the result is (ticks + 1, robots, columns).
    Without drag, unless the numbers say so.
    """
    from cocorosim_ros.world.motion.motion import Stepping, apply_commands, move
    from cocorosim_ros.world.state.state import Z, row_size

    def run(
        numbers: Mapping[str, float],
        starts: Mapping[int, float] | Sequence[Mapping[int, float]],
        commands: Sequence[Sequence[float]],
        **how: Any,
    ) -> Any:
        rows = [starts] if isinstance(starts, Mapping) else starts
        state = np.zeros((1, len(rows), row_size(3)))
        state[..., Z] = -1.0
        for robot, row in enumerate(rows):
            for column, value in row.items():
                state[0, robot, column] = value
        vehicles = robots({"drag": 0.0, "yaw_drag": 0.0, **numbers}, len(rows))
        tick, steps = how.get("tick", 0.5), how.get("steps", 10)
        stepping, tank = Stepping(0, steps, tick / steps, 1), make_tank(how.get("bounds", TANK))
        seen = [state[0].copy()]
        for number, command in enumerate(commands):
            told = np.broadcast_to(np.asarray(command, dtype=float), (1, len(rows), 3)).copy()
            apply_commands(state, told, vehicles)
            move(state, vehicles, tank, stepping, np.zeros(0), number * tick)
            seen.append(state[0].copy())
        return np.array(seen)

    return run


@pytest.fixture(scope="session")
def acceleration(robots: Callable[..., Any]) -> Callable[..., Any]:
    """Function of (numbers, state, forces of the actuators, and time, neighbours): rates (u, v, w, r) of one robot."""
    from cocorosim_ros.world.motion.dynamics import state_rate
    from cocorosim_ros.world.state.state import STATE_SIZE, SURGE, YAW_RATE, Z, row_size
    from cocorosim_ros.world.vehicle_model.vehicles import Body

    def rates(
        numbers: Mapping[str, float], state: Mapping[int, float], forces: Sequence[float] = (0.0, 0.0, 0.0), **at: Any
    ) -> Any:
        vehicles = robots({"drag": 0.0, "yaw_drag": 0.0, **numbers})
        row, rate = np.zeros(row_size(3)), np.zeros(row_size(3))
        row[Z] = -1.0
        for column, value in state.items():
            row[column] = value
        row[STATE_SIZE : STATE_SIZE + 3] = forces
        around = np.asarray(at.get("neighbours", np.zeros((0, 5))), dtype=float)
        lower, upper = (np.array(corner) for corner in at.get("bounds", TANK))
        own = tuple(part[0, 0] for part in vehicles)
        body = Body(own[0], int(own[1]), *own[2:], np.zeros(0), lower, upper, around, at.get("own", -1))
        state_rate(row, at.get("time", 0.0), body, rate)
        return rate[SURGE : YAW_RATE + 1]

    return rates
