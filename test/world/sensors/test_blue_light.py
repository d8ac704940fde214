"""Cones and rays of the blue-light sensors: who is in which cone, and how far the walls are."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

LEFT, RIGHT, BACK, UP, DOWN = range(5)
INFINITE = math.inf
Make = Callable[..., Any]


def around(distance: float, azimuth: float, elevation: float = 0.0) -> Any:
    """Offset (3,) at `distance` [m] in a direction [deg]."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return distance * np.array([math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e)])


@pytest.fixture(scope="module")
def seen(make_simulation: Make) -> Make:
    """Function of offsets [m; world] and the observer's yaw: its neighbour ranges (5,)."""

    def look(offsets: Any, yaw: float = 0.0) -> Any:
        start = np.zeros((1, 1 + len(offsets), 4))
        start[0, :, 2], start[0, 0, 3] = -5.0, yaw
        start[0, 1:, :3] += np.reshape(offsets, (-1, 3))
        return make_simulation(start).sense().neighbour_range[0, 0]

    return look


@pytest.mark.parametrize(
    ("azimuth", "elevation", "sensors"),
    [
        (0.001, 0.0, {LEFT}),
        (-0.001, 0.0, {RIGHT}),
        (30.0, 0.0, {LEFT}),
        (119.999, 0.0, {LEFT}),
        (120.001, 0.0, {BACK}),
        (180.0, 0.0, {BACK}),
        (-120.001, 0.0, {BACK}),
        (-119.999, 0.0, {RIGHT}),
        (60.0, 59.999, {LEFT, UP}),  # up: 30 degrees from its axis
        (60.0, 60.001, {UP}),
        (60.0, 29.999, {LEFT}),
        (-60.0, -30.001, {RIGHT, DOWN}),
        (180.0, -90.0, {DOWN}),
        (0.0, 90.0, {UP}),
    ],
)
def test_cones_are_120_degrees_wide(seen: Make, azimuth: float, elevation: float, sensors: set[int]) -> None:
    """A robot just within a cone's limit is seen by that sensor, just without it is not."""
    reading = seen([around(0.3, azimuth, elevation)])
    assert {index for index in range(5) if math.isfinite(reading[index])} == sensors
    assert all(reading[index] == pytest.approx(0.3) for index in sensors)


def test_exactly_on_the_limit_counts_as_inside(seen: Make) -> None:
    """Straight ahead is the common limit of both front cones, within rounding of cos 60 degrees."""
    for distance in (0.1, 0.25, 0.4):
        assert seen([(distance, 0.0, 0.0)])[:2].tolist() == [distance, distance]


def test_range_is_inclusive(seen: Make) -> None:
    """At 0.5 m a robot is seen, a nanometre further it is not: +inf."""
    assert seen([(0.5, 0.0, 0.0)])[LEFT] == 0.5
    assert seen([(0.5 + 1e-9, 0.0, 0.0)])[LEFT] == INFINITE


def test_the_nearest_of_several_counts(seen: Make) -> None:
    """Each sensor shows the nearest robot of its own cone, whatever their order."""
    offsets = [around(0.4, 50.0), around(0.2, 70.0), around(0.3, 60.0), around(0.45, 170.0)]
    for order in (offsets, offsets[::-1]):
        np.testing.assert_allclose(seen(order), [0.2, INFINITE, 0.45, INFINITE, INFINITE])


def test_nobody_is_infinitely_far(seen: Make) -> None:
    """Alone, or with others out of range, all five read +inf."""
    assert seen([]).tolist() == [INFINITE] * 5
    assert seen([around(0.6, 10.0 * k) for k in range(36)]).tolist() == [INFINITE] * 5


def test_cones_turn_with_the_robot(seen: Make) -> None:
    """Facing north, a robot in the east is to the right; facing west, it is behind."""
    assert np.isfinite(seen([(0.3, 0.0, 0.0)], math.radians(90.0 - 5.0))).tolist() == [False, True] + [False] * 3
    assert np.isfinite(seen([(0.3, 0.0, 0.0)], math.pi)).tolist() == [False, False, True, False, False]


def test_random_swarm_by_angles(make_simulation: Make, blue_light: SimpleNamespace, crowd: Make) -> None:
    """For 30 robots, readings are those found by angles between vectors, robot by robot."""
    start = crowd(1, 30, seed=4)
    reading = make_simulation(start).sense().neighbour_range[0]
    for robot in range(30):
        x, y, z, yaw = start[0, robot]
        cosine, sine = math.cos(yaw), math.sin(yaw)
        offset = (start[0, :, :3] - (x, y, z)) @ np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
        distance = np.linalg.norm(offset, axis=1)
        others = (distance <= 0.5) & (np.arange(30) != robot)
        for sensor in range(5):
            angle = np.arccos(np.clip(offset @ blue_light.axes[sensor] / np.maximum(distance, 1e-9), -1, 1))
            hits = distance[others & (angle <= math.radians(60.0))]
            assert reading[robot, sensor] == pytest.approx(min(hits, default=INFINITE))


@pytest.mark.parametrize(
    ("place", "yaw", "expected"),
    [
        # rays of 0, 60, 120 (left), 0, -60, -120 (right), 180, 120, 240 degrees (back)
        ((2.8, 0.0, -1.0), 0.0, (0.2, 0.2, INFINITE, INFINITE, INFINITE)),
        ((2.8, 0.0, -1.0), 180.0, (INFINITE, INFINITE, 0.2, INFINITE, INFINITE)),
        ((0.0, 2.8, -1.0), 0.0, (0.4 / 3**0.5, INFINITE, 0.4 / 3**0.5, INFINITE, INFINITE)),
        ((0.0, -2.8, -1.0), 0.0, (INFINITE, 0.4 / 3**0.5, 0.4 / 3**0.5, INFINITE, INFINITE)),
        ((2.9, 0.0, -1.0), 60.0, (0.2, 0.1, 0.2, INFINITE, INFINITE)),
        ((0.0, 0.0, -0.1), 10.0, (INFINITE, INFINITE, INFINITE, 0.1, INFINITE)),
        ((0.0, 0.0, -1.8), 10.0, (INFINITE, INFINITE, INFINITE, INFINITE, 0.2)),
        ((2.69, 0.0, -1.0), 0.0, (INFINITE,) * 5),
    ],
)
def test_obstacles_by_rays(make_simulation: Make, place: Any, yaw: float, expected: Any) -> None:
    """Near a wall, floor or surface each sensor shows the shortest of its rays; beyond 0.3 m +inf."""
    bounds = ((-3.0, -3.0, -2.0), (3.0, 3.0, 0.0))
    simulation = make_simulation([[[*place, math.radians(yaw)]]], bounds=bounds)
    np.testing.assert_allclose(simulation.sense().obstacle_range[0, 0], expected, rtol=0, atol=1e-12)
