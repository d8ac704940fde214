"""Force and yaw moment of the patches on a robot."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.water.force_field.push import push_robots
from cocorosim_ros.world.water.patches import Patches

PATCHES = Patches(np.array([-0.5, -0.5, -1.0]), 0.1, 10, 10, 10)


def centres() -> Any:
    """(3, nz, ny, nx) x, y, z of all patch centres."""
    z, y, x = np.meshgrid(*[np.arange(10) * 0.1 + 0.05 + low for low in (-1.0, -0.5, -0.5)], indexing="ij")
    return np.stack([x, y, z])


def pushed(field: Any, place: Any, lever: float = 0.1) -> Any:
    """Force and moment (4,) on one robot."""
    push = np.zeros((1, 4))
    push_robots(np.ascontiguousarray(field), PATCHES, lever, np.array([[*place, 0.3, 0, 0, 0, 0]]), push)
    return push[0]


def test_force_is_that_of_the_patch() -> None:
    """Anywhere within a patch its force holds, and at the outermost places that of the last patch."""
    field = np.random.default_rng(1).normal(size=(3, 10, 10, 10))
    assert pushed(field, [0.11, -0.19, -0.31])[:3].tolist() == field[:, 6, 3, 6].tolist()
    assert pushed(field, [0.19, -0.11, -0.39])[:3].tolist() == field[:, 6, 3, 6].tolist()
    assert pushed(field, [0.5, -0.5, 0.0])[:3].tolist() == field[:, 9, 0, 9].tolist()


@pytest.mark.parametrize("rate", [2.0, -2.0])
def test_rigid_rotation(rate: float) -> None:
    """F = rate (-y, x): four neighbours at h push rate h each, so N = 4 rate h lever, counter-clockwise positive."""
    x, y, _ = centres()
    field = np.stack([-rate * y, rate * x, 0.0 * x])
    assert pushed(field, [0.05, 0.05, -0.55])[3] == pytest.approx(4.0 * rate * 0.1 * 0.1, rel=1e-12)
    assert pushed(field, [0.05, 0.05, -0.55], lever=0.44)[3] == pytest.approx(4.0 * rate * 0.1 * 0.44, rel=1e-12)


def test_it_is_the_moment_of_the_four_forces() -> None:
    """With a lever of one patch: the sum of r x F over the four neighbours' centres, by numpy's cross product."""
    field = np.random.default_rng(2).normal(size=(3, 10, 10, 10))
    moment = 0.0
    for i, j in ((6, 5), (4, 5), (5, 6), (5, 4)):
        r = np.array([0.1 * (i - 5), 0.1 * (j - 5), 0.0])
        moment += np.cross(r, field[:, 5, j, i])[2]
    assert pushed(field, [0.05, 0.05, -0.45])[3] == pytest.approx(moment, rel=1e-12)


def test_strain_and_uniform_force_do_not_turn() -> None:
    """Neither a uniform force nor pure strain (y, x) of the water has a moment."""
    x, y, _ = centres()
    assert pushed(np.stack([1.0 + 0 * x, 2.0 + 0 * x, 3.0 + 0 * x]), [0.05, 0.05, -0.55])[3] == 0.0
    assert pushed(np.stack([y, x, 0 * x]), [0.05, 0.05, -0.55])[3] == pytest.approx(0.0, abs=1e-15)


def test_beyond_a_wall_there_is_no_force() -> None:
    """Beside the east wall the neighbour that is not there counts as zero."""
    field = np.zeros((3, 10, 10, 10))
    field[1, :, :, 8] = 1.0
    field[1, :, :, 9] = 5.0
    assert pushed(field, [0.5, 0.05, -0.55])[3] == pytest.approx(-0.1)
