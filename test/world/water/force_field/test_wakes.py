"""Currents made by thrusters: figure 2a of the paper, for both thrusters and both directions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.world.water.force_field.wakes import Wake, blow_wakes
from cocorosim_ros.world.water.patches import Patches

PATCHES = Patches(np.array([-0.55, -0.55, -1.1]), 0.1, 11, 11, 11)
LEFT, RIGHT = [0.0, 1.0, 1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 1.0, 0.0, 0.0, -1.0]
PAPER = Wake(1.0, 1.0)


def wake(left: float, right: float, yaw: float = 0.0, place: Any = (0.0, 0.0, -0.55), how: Any = PAPER) -> Any:
    """Forces of a robot's thrusters; it sits in patch (5, 5, 5)."""
    field = np.zeros((3, 11, 11, 11))
    row = np.array([*place, yaw, 0, 0, 0, 0, left, right, 7.0])
    blow_wakes(field, PATCHES, row[None], np.array([[LEFT, RIGHT]]), how)
    return field


def forces(field: Any) -> dict[tuple[int, int, int], list[float]]:
    """Forces (Fx, Fy, Fz) by patch, counted from the robot's in x, y, z."""
    there = np.argwhere(field.any(axis=0))
    return {(int(i) - 5, int(j) - 5, int(k) - 5): field[:, k, j, i].tolist() for k, j, i in there}


def test_left_thruster_ahead() -> None:
    """4 N: 4 towards the robot at its left; 1 backwards behind, behind-up, behind-down, behind-left."""
    assert forces(wake(4.0, 0.0)) == {
        (0, 1, 0): [0.0, -4.0, 0.0],
        (-1, 0, 0): [-1.0, 0.0, 0.0],
        (-1, 0, 1): [-1.0, 0.0, 0.0],
        (-1, 0, -1): [-1.0, 0.0, 0.0],
        (-1, 1, 0): [-1.0, 0.0, 0.0],
    }


def test_left_thruster_astern() -> None:
    """The same, mirrored to the front; the suction stays at the left."""
    assert forces(wake(-4.0, 0.0)) == {
        (0, 1, 0): [0.0, -4.0, 0.0],
        (1, 0, 0): [1.0, 0.0, 0.0],
        (1, 0, 1): [1.0, 0.0, 0.0],
        (1, 0, -1): [1.0, 0.0, 0.0],
        (1, 1, 0): [1.0, 0.0, 0.0],
    }


@pytest.mark.parametrize("force", [4.0, -4.0])
def test_right_thruster_is_the_mirror_image(force: float) -> None:
    """Left and right exchanged: y and Fy change sign."""
    mirrored = {(i, -j, k): [fx, -fy, fz] for (i, j, k), (fx, fy, fz) in forces(wake(force, 0.0)).items()}
    assert forces(wake(0.0, force)) == mirrored


def test_a_quarter_turn() -> None:
    """Heading north the picture is turned by 90 degrees counter-clockwise."""
    turned = forces(wake(4.0, 0.0, yaw=math.pi / 2))
    expected = {(-j, i, k): [-fy, fx, fz] for (i, j, k), (fx, fy, fz) in forces(wake(4.0, 0.0)).items()}
    assert turned.keys() == expected.keys()
    for place, force in turned.items():
        np.testing.assert_allclose(force, expected[place], rtol=0, atol=1e-14)


def test_strength_and_thrusters_add() -> None:
    """Fifty times the force, and both thrusters together are the sum of each."""
    both = wake(4.0, -2.0, yaw=0.7, how=Wake(50.0, 1.0))
    np.testing.assert_allclose(both, 50.0 * (wake(4.0, 0.0, yaw=0.7) + wake(0.0, -2.0, yaw=0.7)), atol=1e-13)
    assert not wake(0.0, 0.0).any()


def test_as_much_is_sucked_as_is_blown() -> None:
    """In open water at any heading: the sum of all vectors is F to the right and F backwards."""
    for yaw in np.linspace(-3.0, 3.0, 25):
        field = wake(4.0, 0.0, yaw=yaw)
        back, right = np.array([-math.cos(yaw), -math.sin(yaw)]), np.array([math.sin(yaw), -math.cos(yaw)])
        np.testing.assert_allclose(field.sum(axis=(1, 2, 3))[:2], 4.0 * back + 4.0 * right, atol=1e-13)


def test_at_a_wall_what_has_no_water_is_lost() -> None:
    """With its back to the west wall and at the surface nothing is blown, and only the suction is left."""
    assert forces(wake(4.0, 0.0, place=(-0.5, 0.0, -0.05))) == {(-5, 1, 5): [0.0, -4.0, 0.0]}
