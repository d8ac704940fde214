"""Obstacle sensors apart from blue light, against distances to a wall worked out by hand."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses
from cocorosim_ros.world.tick.assembly import build_world
from cocorosim_ros.world.tick.simulation import Simulation

SCENARIO = """\
name: beside
description: robots beside a wall
seed: 1
tick: 0.5 s
duration: 1 s
tank: {size: [6 m, 6 m, 2 m]}
integrator: {name: semi_implicit_euler, step: 0.5 s, contact: stop_position}
swarm:
  - {platform: PLATFORM, count: COUNT, prefix: robot, controller: idle, start: {poses: POSES}}
"""
FRONT, LEFT, BACK, RIGHT = range(5, 9)
EDGE = math.radians(62.5)


def readings(folder: Path, platform: str, *poses: str) -> Any:
    """What robots of a platform at these poses see in the first tick."""
    path = folder / "beside.yaml"
    text = SCENARIO.replace("PLATFORM", platform).replace("COUNT", str(len(poses)))
    path.write_text(text.replace("POSES", f"[{', '.join(poses)}]"))
    scenario = load_scenario(path)
    return Simulation(build_world(scenario), start_poses(scenario)[None]).sense()


def wall_ahead(clearance: float, yaw: float) -> list[float]:
    """Front, left, back and right [m] by a wall at `clearance` [m] to the east of a robot at `yaw` [rad]."""
    shortest = []
    for side in (0.0, 0.5 * math.pi, math.pi, -0.5 * math.pi):
        east = [math.cos(yaw + side + turn) for turn in (0.0, EDGE, -EDGE)]
        ranges = [clearance / part for part in east if part > 0.0 and clearance / part <= 0.3]
        shortest.append(min(ranges, default=math.inf))
    return shortest


@pytest.mark.parametrize("yaw", [0.0, 20.0, 45.0, 90.0, 155.0, -100.0])
@pytest.mark.parametrize("clearance", [0.1, 0.2, 0.28])
def test_four_directions_of_three_rays(tmp_path: Path, yaw: float, clearance: float) -> None:
    """Each of the four shows the shortest of its rays at 0 and +-62.5 degrees; the blue-light ones see no wall."""
    seen = readings(tmp_path, "lily_released", f"[{3.0 - clearance} m, 0 m, -1 m, {yaw} deg]").obstacle_range[0, 0]
    np.testing.assert_allclose(seen[FRONT:], wall_ahead(clearance, math.radians(yaw)), rtol=0, atol=1e-9)
    assert np.isinf(seen[:FRONT]).all()


def test_who_touches_a_wall_does_not_see_it_by_blue_light(tmp_path: Path) -> None:
    """A range of zero sees nothing, though the wall is at zero; the sensor ahead shows zero."""
    seen = readings(tmp_path, "lily_released", "[3 m, 0 m, -1 m, 0 deg]").obstacle_range[0, 0]
    assert np.isinf(seen[:4]).all()
    assert seen[FRONT] == 0.0


def test_floor_by_the_downward_sensor(tmp_path: Path) -> None:
    """15 cm above the floor the downward sensor alone shows something."""
    seen = readings(tmp_path, "lily_released", "[0 m, 0 m, -1.85 m, 0 deg]").obstacle_range[0, 0]
    assert seen[4] == pytest.approx(0.15)
    assert np.isinf(np.delete(seen, 4)).all()


def test_they_see_no_robot_and_cones_are_125_degrees_wide(tmp_path: Path) -> None:
    """A robot 62.4 degrees off the axis of front_left (2.4 to the right of the bow) is seen by both front sensors.

    With cones of 120 degrees it would be seen by front_right alone; no obstacle sensor sees it.
    """
    place = [0.3 * math.cos(math.radians(-2.4)), 0.3 * math.sin(math.radians(-2.4))]
    both = ("[0 m, 0 m, -1 m, 0 deg]", f"[{place[0]} m, {place[1]} m, -1 m, 0 deg]")
    for platform, sensors in (("lily_released", {0, 1}), ("lily_paper", {1})):
        seen = readings(tmp_path, platform, *both)
        found = np.flatnonzero(np.isfinite(seen.neighbour_range[0, 0])).tolist()
        assert set(found) == sensors
        assert np.isinf(seen.obstacle_range).all()


def test_a_platform_without_the_key_has_none_and_says_none() -> None:
    """lily has no obstacle sensors, and its description no such key, so that digests of scenarios stay."""
    lily = load_platform("lily")
    assert lily.sensors.obstacles is None
    assert lily.sensors.directed == lily.sensors.blss
    assert "obstacles" not in platform_tree(lily)["sensors"]


def test_the_tree_gives_the_same_platform_back() -> None:
    """lily_released survives being written and read."""
    platform = load_platform("lily_released")
    again = read_platform(entry_of(platform_tree(platform), "a test"))
    assert again.sensors == platform.sensors


def test_names_are_unique_among_all_that_look(tmp_path: Path) -> None:
    """An obstacle sensor called like a blue-light sensor is refused by name."""
    text = (Path(load_platform("lily_released").origin)).read_text().replace("obstacle_back", "back")
    path = tmp_path / "twice.yaml"
    path.write_text(text)
    with pytest.raises(CocorosimError, match="the name 'back' more than once"):
        load_platform(path)
