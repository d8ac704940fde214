"""Cones in vectors against the rule for one sensor and one robot, written out."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest


@pytest.mark.parametrize("sensors", [1, 4, 5, 9])
def test_any_number_of_cones_sees_the_nearest(sensors: int, make_instruments: Callable[..., Any]) -> None:
    """Random cones and places: the nearest robot within range and angle, its number, and nobody where there is none."""
    from cocorosim_ros.world.sensors.blue_light import neighbour_ranges
    from cocorosim_ros.world.sensors.cones import cones_of

    random, robots = np.random.default_rng(sensors), 12
    axis = random.normal(size=(robots, sensors, 3))
    axis /= np.linalg.norm(axis, axis=2, keepdims=True)
    half, reach = random.uniform(0.0, 1.0, (robots, sensors)), random.uniform(0.3, 1.5, (robots, sensors))
    instruments = make_instruments(robots)._replace(axis=axis, cosine_half_angle=half, neighbour_range=reach)
    states = np.zeros((robots, 8))
    states[:, :4] = random.uniform(-1.0, 1.0, (robots, 4))
    reading, nearest = np.full(sensors, np.nan), np.full(sensors, 99)
    for robot in range(robots):
        nearby = np.delete(np.arange(robots, dtype=np.int32), robot)
        neighbour_ranges(states, robot, nearby, cones_of(instruments), reading, nearest)
        for sensor in range(sensors):
            seen = _seen(states, robot, axis[robot, sensor], half[robot, sensor])
            found = [(distance, other) for distance, other in seen if distance <= reach[robot, sensor]]
            distance, other = min(found, default=(math.inf, -1))
            assert (reading[sensor], nearest[sensor]) == (pytest.approx(distance, rel=1e-12), other)


def _seen(states: Any, robot: int, axis: Any, cosine_half: float) -> list[tuple[float, int]]:
    """Distance and number of everybody in the cone with that axis."""
    found = []
    for other in range(len(states)):
        x, y, z = states[other, :3] - states[robot, :3]
        sine, cosine = math.sin(states[robot, 3]), math.cos(states[robot, 3])
        distance = math.sqrt(x * x + y * y + z * z)
        along = np.dot([x * cosine + y * sine, y * cosine - x * sine, z], axis)
        if other != robot and along >= distance * cosine_half:
            found.append((distance, other))
    return found
