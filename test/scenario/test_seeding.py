"""Random generators by name, and the random start."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import generator, start_poses

from .conftest import BOX, ScenarioFile

ARGUMENTS = [
    (1, "start", "lily_01", 0),
    (2, "start", "lily_01", 0),
    (1, "noise", "lily_01", 0),
    (1, "start", "lily_02", 0),
    (1, "start", "lily_01", 1),
    (1, "start", "", 0),
    (1 + 2**32, "start", "lily_01", 0),
]


def draws(arguments: tuple[int, str, str, int]) -> list[float]:
    """The first numbers of a generator."""
    return list(generator(*arguments).random(4))


def test_same_arguments_same_numbers() -> None:
    """Whatever else is made before or between, the same four arguments give the same numbers."""
    first = [draws(arguments) for arguments in ARGUMENTS]
    again = [draws(arguments) for arguments in reversed(ARGUMENTS)]
    assert first == again[::-1]


def test_each_argument_matters() -> None:
    """Changing seed, purpose, robot or run changes the numbers; purpose and robot do not run together."""
    numbers = [draws(arguments) for arguments in ARGUMENTS]
    assert len({tuple(row) for row in numbers}) == len(ARGUMENTS)
    assert draws((1, "ab", "c", 0)) != draws((1, "a", "bc", 0))


def test_generators_are_uncorrelated() -> None:
    """The streams of two robots correlate no more than chance: |r| < 5 / sqrt(n)."""
    one, other = (
        generator(1, "noise", "lily_01").random(10_000),
        generator(1, "noise", "lily_02").random(10_000),
    )
    assert abs(np.corrcoef(one, other)[0, 1]) < 0.05


def test_start_is_in_the_box_and_apart(scenario_file: ScenarioFile) -> None:
    """Robots start inside their box, a hull length from each other, with headings all around."""
    scenario = load_scenario(scenario_file(("count: 3", "count: 60")))
    poses = start_poses(scenario)
    assert poses.shape == (60, 4)
    assert np.all(np.abs(poses[:, :3] - [0, 0, -1]) <= 0.5)
    assert min(math.dist(a[:3], b[:3]) for a, b in itertools.combinations(poses, 2)) >= 0.13
    assert np.ptp(poses[:, 3]) > math.pi
    assert np.all(np.abs(poses[:, 3]) <= math.pi)


def test_robots_after_it_do_not_move_a_robot(scenario_file: ScenarioFile) -> None:
    """The first three of thirty start where the three would start alone; seed and run change it."""
    few = load_scenario(scenario_file())
    many = load_scenario(scenario_file(("count: 3", "count: 30")))
    np.testing.assert_array_equal(start_poses(few), start_poses(many)[:3])
    assert not np.any(start_poses(few) == start_poses(few, run=1))
    assert not np.any(start_poses(few) == start_poses(load_scenario(scenario_file(), seed=4)))


def test_start_avoids_obstacles_and_given_poses(scenario_file: ScenarioFile) -> None:
    """Random places are outside obstacles, and far from robots at given poses even of later groups."""
    ball = "tank:\n  obstacles: [{name: ball, kind: sphere, centre: [0 m, 0 m, -1 m], radius: 0.5 m}]"
    start = "{poses: [[0.4 m, 0.4 m, -1.4 m, 1 rad]]}"
    given = f"  - {{platform: lily, prefix: fish, controller: idle, start: {start}}}\n"
    path = scenario_file(("tank:", ball), ("count: 3", "count: 40"), (f"      {BOX}\n", f"      {BOX}\n{given}"))
    poses = start_poses(load_scenario(path))
    assert np.all(np.linalg.norm(poses[:, :3] - [0, 0, -1], axis=1) > 0.5)
    assert poses[40] == pytest.approx([0.4, 0.4, -1.4, 1.0])
    assert np.all(np.linalg.norm(poses[:40, :3] - poses[40, :3], axis=1) >= 0.13)
