"""Vehicles in six degrees of freedom, and how a test moves them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.motion.motion import Stepping
from cocorosim_ros.world.surroundings.tank import Tank

Swim = Callable[..., Any]
STILL = np.zeros(0)


def open_water() -> Tank:
    """A tank whose walls nobody reaches, with neither surface nor floor."""
    far = np.full(3, 1e4)
    return Tank(-far, far, np.zeros((0, 4)), np.zeros((0, 6)))


@pytest.fixture(scope="session")
def swim() -> Swim:
    """Function of (vehicle, row, seconds, step, command, flow): states (steps + 1, 13) far from walls."""
    from cocorosim_ros.world.six_degrees import swimming
    from cocorosim_ros.world.six_degrees.bodies import build_bodies

    def run(vehicle: Any, row: Any, seconds: float, step: float, command: Any = (), flow: Any = STILL) -> Any:
        school = swimming.School(build_bodies([vehicle]), np.zeros(1, dtype=np.int64))
        state = np.array(row, dtype=np.float64).reshape(1, 1, 13)
        asked, seen = np.array(command, dtype=np.float64).reshape(1, 1, -1), np.zeros((1, 1, 8))
        around = swimming.Around(flow, open_water(), np.zeros(asked.shape[2]))
        states = [state[0, 0].copy()]
        for index in range(round(seconds / step)):
            moment = swimming.Moment(index * step, Stepping(0, 1, step, 0))
            swimming.swim(state, asked, school, around, moment, seen)
            states.append(state[0, 0].copy())
        return np.array(states)

    return run


@pytest.fixture(scope="session")
def start() -> Callable[..., Any]:
    """Function of (velocity (6,), roll, pitch, yaw): a row (13,) at 100 m depth."""
    from cocorosim_ros.world.six_degrees.attitude import attitude_of

    def row(velocity: Any = (0,) * 6, roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> Any:
        return np.concatenate([[0.0, 0.0, -100.0], attitude_of(roll, pitch, yaw), velocity])

    return row


@pytest.fixture(scope="session")
def lopsided() -> Any:
    """A vehicle without damping whose mass matrix has every entry: heavy below and behind, with coupled added mass."""
    from cocorosim_ros.world.six_degrees.vehicle import Vehicle

    draw = np.random.default_rng(11)
    root = draw.normal(size=(6, 6))
    inertia = np.array([[0.4, 0.03, -0.02], [0.03, 0.9, 0.05], [-0.02, 0.05, 1.1]])
    return Vehicle(
        mass=10.0, inertia=inertia, added_mass=root @ root.T,
        centre_of_gravity=np.array([-0.05, 0.02, -0.08]), centre_of_buoyancy=np.array([0.01, 0.0, 0.04]),
        weight=98.1, buoyancy=99.0,
    )  # fmt: skip
