"""Markers say where walls, obstacles, robots' ways and jets are, in numbers that a drawing can be made of."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.light import Lamp, Light
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.tank import Box, Sphere, Tank
from cocorosim_ros.wire.cdr.type_store import deserialize
from cocorosim_ros.wire.topics.markers import ARRAY, CUBE, LINE_LIST, SPHERE, TEXT, SwarmMarkers, tank_markers

SECOND = 1_000_000_000
GRAIN = 1e-3  # m, to which places of moving markers are rounded


@pytest.fixture
def lily() -> Platform:
    """Two thrusters behind, then a pump."""
    return load_platform("lily")


@pytest.fixture
def by_group() -> Callable[[bytes], dict[str, list[Any]]]:
    """Function of a message: its markers by their namespaces."""

    def read(data: bytes) -> dict[str, list[Any]]:
        groups: dict[str, list[Any]] = {}
        for marker in deserialize(ARRAY, data).markers:
            groups.setdefault(marker.ns, []).append(marker)
        return groups

    return read


def points(marker: Any) -> np.ndarray:
    """(p, 3) the points of a marker."""
    return np.array([[point.x, point.y, point.z] for point in marker.points])


def test_tank(by_group: Callable[[bytes], dict[str, list[Any]]]) -> None:
    """Twelve edges between the corners of the water, solids in their sizes, lamps, a name above each robot."""
    tank = Tank(
        (6.0, 4.0, 2.0), (Sphere("ball", (1.0, 0.0, -1.0), 0.25), Box("crate", (0.0, 1.0, -1.5), (1.0, 2.0, 0.5)))
    )
    light = Light(0.0, (Lamp("spot", (0.5, 0.5, -2.0), 100.0, 0.3),))
    groups = by_group(tank_markers(tank, light, ["a", "b"]))
    edges = points(groups["tank"][0]).reshape(12, 2, 3)
    assert groups["tank"][0].type == LINE_LIST
    lengths = np.abs(edges[:, 1] - edges[:, 0])
    assert sorted(map(tuple, lengths)) == sorted([(6.0, 0, 0), (0, 4.0, 0), (0, 0, 2.0)] * 4)
    assert {tuple(corner) for corner in edges.reshape(-1, 3)} == {
        (x, y, z) for x in (-3.0, 3.0) for y in (-2.0, 2.0) for z in (-2.0, 0.0)
    }
    ball, crate = groups["obstacles"]
    assert (ball.type, ball.scale.x, ball.pose.position.x, ball.pose.position.z) == (SPHERE, 0.5, 1.0, -1.0)
    assert (crate.type, crate.scale.x, crate.scale.y, crate.scale.z) == (CUBE, 1.0, 2.0, 0.5)
    assert groups["lamps"][0].pose.position.z == -2.0
    names = [(each.type, each.text, each.header.frame_id, each.frame_locked) for each in groups["names"]]
    assert names == [(TEXT, "a", "a/base_link", True), (TEXT, "b", "b/base_link", True)]


def test_without_a_tank_names_are_left(by_group: Callable[[bytes], dict[str, list[Any]]]) -> None:
    """Real robots swim in a tank that nothing describes."""
    assert list(by_group(tank_markers(None, None, ["boat"]))) == ["names"]


def test_trails(lily: Platform, by_group: Callable[[bytes], dict[str, list[Any]]]) -> None:
    """A message holds each robot's way since the last one; later ones take the place of the oldest."""
    markers = SwarmMarkers([lily, lily], 10)
    first, second = np.array([[0.0, 0, -1], [1, 1, -1]]), np.array([[0.5, 0, -1], [1, 2, -1]])
    nothing = np.zeros((2, 3))
    messages = [markers.encode(n * 10 * SECOND, (first, second)[n % 2], np.zeros(2), nothing) for n in range(4)]
    trails = [by_group(data)["trails"][0] for data in messages]
    assert points(trails[0]).reshape(2, 2, 3) == pytest.approx(np.stack([first, first], axis=1))
    assert points(trails[1]).reshape(2, 2, 3) == pytest.approx(np.stack([first, second], axis=1))
    assert [each.id for each in trails] == [0, 1, 2, 0]
    assert [each.header.stamp.sec for each in trails] == [0, 10, 20, 30]
    assert {each.lifetime.sec for each in trails} == {30}
    colours = [(each.r, each.g, each.b) for each in trails[0].colors]
    assert colours[0] == colours[1] != colours[2] == colours[3]


def test_jets_blow_against_the_push(lily: Platform, by_group: Callable[[bytes], dict[str, list[Any]]]) -> None:
    """A robot that points north and drives with its left thruster at half command blows 0.15 m to the south."""
    command = np.array([[0.5, 0.0, 1.0]])
    data = SwarmMarkers([lily], 2).encode(0, np.array([[1.0, 2.0, -1.0]]), np.array([np.pi / 2]), command)
    left, right = points(by_group(data)["wakes"][0]).reshape(2, 2, 3)
    x, y, _ = lily.actuators[0].position  # type: ignore[union-attr]
    assert left[0] == pytest.approx([1.0 - y, 2.0 + x, -1.0], abs=GRAIN)
    assert left[1] - left[0] == pytest.approx([0.0, -0.15, 0.0], abs=2 * GRAIN)
    assert right[1] == pytest.approx(right[0], abs=GRAIN)


def test_a_robot_out_of_sight_stays_and_is_off(
    lily: Platform, by_group: Callable[[bytes], dict[str, list[Any]]]
) -> None:
    """No number of a marker is ever NaN, which RViz would refuse."""
    markers = SwarmMarkers([lily], 2)
    nowhere = np.full((1, 3), np.nan)
    for position, yaw in (
        (nowhere, np.array([np.nan])),
        (np.array([[1.0, 0, 0]]), np.zeros(1)),
        (nowhere, np.zeros(1)),
    ):
        groups = by_group(markers.encode(0, position, yaw, np.ones((1, 3))))
        assert np.isfinite(points(groups["trails"][0])).all()
        assert np.isfinite(points(groups["wakes"][0])).all()
    assert points(groups["trails"][0]) == pytest.approx(np.array([[1.0, 0, 0]] * 2))


def test_a_robot_without_thrusters_has_no_jets(by_group: Callable[[bytes], dict[str, list[Any]]]) -> None:
    """A float has a pump alone."""
    floater = load_platform("floater")
    data = SwarmMarkers([floater], 2).encode(0, np.zeros((1, 3)), np.zeros(1), np.ones((1, len(floater.actuators))))
    assert list(by_group(data)) == ["trails"]
