"""One seed to independent random generators, named by purpose and robot; and the random start of a swarm."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.swarm import StartBox
from cocorosim_ros.scenario.scenario import Scenario

_MOST_TRIES = 1000
_WORD = 0xFFFFFFFF


def generator(seed: int, purpose: str, robot: str = "", run: int = 0) -> np.random.Generator:
    """The generator of one robot for one purpose in one run.

    It depends on these four alone: not on the order in which generators are made, nor on how many there are.
    seed, run: from 0 to 2**64 - 1.
    """
    words = [seed & _WORD, seed >> 32, run & _WORD, run >> 32, *_words(purpose), *_words(robot)]
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence(words)))


def start_poses(scenario: Scenario, run: int = 0) -> Floats:
    """(n_robots, 4) x, y, z [m; world] and yaw [rad] of the robots at the start, in their order.

    Random places are uniform in the group's box, outside obstacles, at least a hull length from all others;
    random headings are uniform. A robot's draws do not depend on the robots after it.
    Raises CocorosimError when a robot finds no room in 1000 tries.
    """
    poses = np.full((len(scenario.robots), 4), np.nan)
    lengths = np.array([robot.platform.hull.length for robot in scenario.robots])
    first = 0
    boxes: list[tuple[int, StartBox]] = []
    for group in scenario.swarm:
        indices = range(first, first + group.count)
        if group.start.poses is not None:
            poses[first : first + group.count] = group.start.poses
        elif group.start.box is not None:
            boxes += [(index, group.start.box) for index in indices]
        first += group.count
    for index, box in boxes:
        random = generator(scenario.seed, "start", scenario.robots[index].name, run)
        heading = random.uniform(-np.pi, np.pi)
        poses[index] = (*_free_place(scenario, box, index, _Robots(poses, lengths), random), heading)
    return poses


@dataclass(frozen=True)
class _Robots:
    """All robots of a run while they are placed."""

    poses: Floats
    """(robots, 4) x, y, z [m; world] and heading [rad], NaN for those that have no place yet."""
    lengths: Floats
    """(robots,) of their hulls [m]."""


def _free_place(scenario: Scenario, box: StartBox, index: int, robots: _Robots, random: np.random.Generator) -> Floats:
    """(3,) a place in the box that is far enough from those that have one."""
    placed, lengths = ~np.isnan(robots.poses[:, 0]), robots.lengths
    positions, spacing = robots.poses[placed, :3], (lengths[placed] + lengths[index]) / 2
    low, high = np.array(box.lower_corner()), np.array(box.upper_corner())
    for _ in range(_MOST_TRIES):
        place: Floats = random.uniform(low, high)
        near = np.sum((positions - place) ** 2, axis=1) < spacing**2
        if not near.any() and scenario.tank.obstacle_at((place[0], place[1], place[2])) is None:
            return place
    size = " x ".join(f"{side:g} m" for side in box.size)
    raise CocorosimError(
        f"'{scenario.robots[index].name}' finds no room in the start box of {size} at least "
        f"{lengths[index]:g} m (its hull) from {len(positions)} others; enlarge the box or take fewer robots."
    )


def _words(name: str) -> list[int]:
    digest = hashlib.sha256(name.encode()).digest()
    return [int.from_bytes(digest[i : i + 4], "little") for i in range(0, 16, 4)]
