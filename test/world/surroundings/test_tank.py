"""Rays against analytic cases and against marching along them point by point."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

BOUNDS = ((-3.0, -2.0, -2.0), (3.0, 2.0, 0.0))
SPHERES = ((0.5, 0.5, -1.0, 0.3), (-1.0, -0.5, -0.5, 0.4))
BOXES = ((1.0, -1.0, -2.0, 1.5, 1.0, -0.8), (-2.5, 0.8, -2.0, -2.0, 1.4, 0.0))
DIAGONAL = 1.0 / math.sqrt(2.0)
Make = Callable[..., Any]


def cast(tank: Any, origin: Any, direction: Any) -> float:
    """Range [m] along a ray."""
    from cocorosim_ros.world.surroundings.tank import ray_range

    return float(ray_range(tank, np.array(origin, dtype=float), np.array(direction, dtype=float), math.inf))


@pytest.mark.parametrize(
    ("origin", "direction", "distance"),
    [
        ((0.0, 0.0, -1.0), (1.0, 0.0, 0.0), 3.0),
        ((0.5, 0.0, -1.0), (-1.0, 0.0, 0.0), 3.5),
        ((0.0, 0.5, -1.0), (0.0, 1.0, 0.0), 1.5),
        ((0.0, 0.5, -1.0), (0.0, -1.0, 0.0), 2.5),
        ((0.0, 0.0, -0.3), (0.0, 0.0, 1.0), 0.3),
        ((0.0, 0.0, -0.3), (0.0, 0.0, -1.0), 1.7),
        ((2.5, 0.0, -1.0), (DIAGONAL, DIAGONAL, 0.0), 0.5 * math.sqrt(2.0)),
        ((2.0, 1.9, -1.0), (DIAGONAL, DIAGONAL, 0.0), 0.1 * math.sqrt(2.0)),
        ((3.0, 0.0, -1.0), (1.0, 0.0, 0.0), 0.0),
    ],
)
def test_walls_floor_and_surface(make_tank: Make, origin: Any, direction: Any, distance: float) -> None:
    """In an empty tank a ray ends at the plane that it meets first."""
    assert cast(make_tank(BOUNDS), origin, direction) == pytest.approx(distance, abs=1e-12)


@pytest.mark.parametrize(
    ("offset", "distance"),
    [(0.0, 0.7), (0.18, 0.76), (0.3 - 1e-9, 1.0), (0.3 + 1e-9, 3.0)],
)
def test_sphere(make_tank: Make, offset: float, distance: float) -> None:
    """A ray `offset` m beside the centre of a sphere 1 m ahead ends at 1 - sqrt(0.3^2 - offset^2), or not."""
    tank = make_tank(BOUNDS, spheres=[(1.0, offset, -1.0, 0.3)])
    assert cast(tank, (0.0, 0.0, -1.0), (1.0, 0.0, 0.0)) == pytest.approx(distance, abs=1e-4)


@pytest.mark.parametrize(
    ("direction", "distance"),
    [
        ((1.0, 0.0, 0.0), 1.0),
        ((DIAGONAL, DIAGONAL, 0.0), math.sqrt(2.0)),
        ((math.cos(math.radians(50)), math.sin(math.radians(50)), 0.0), 2.0 / math.sin(math.radians(50))),
    ],
)
def test_box(make_tank: Make, direction: Any, distance: float) -> None:
    """A box from x = 1 and y = 1 down: met at its face and at its edge, and missed beside its edge."""
    tank = make_tank(BOUNDS, boxes=[(1.0, -1.0, -2.0, 2.0, 1.0, -0.5)])
    assert cast(tank, (0.0, 0.0, -1.0), direction) == pytest.approx(distance, abs=1e-12)


def test_what_lies_behind_is_not_seen(make_tank: Make) -> None:
    """Solids behind the origin do not shorten a ray."""
    tank = make_tank(BOUNDS, spheres=[(-1.0, 0.0, -1.0, 0.3)], boxes=[(-2.0, -1.0, -2.0, -1.5, 1.0, 0.0)])
    assert cast(tank, (0.0, 0.0, -1.0), (1.0, 0.0, 0.0)) == 3.0


def test_from_within_a_solid_the_range_is_zero(make_tank: Make) -> None:
    """Inside a sphere or a box every direction reads 0."""
    tank = make_tank(BOUNDS, spheres=SPHERES, boxes=BOXES)
    for origin in ((0.5, 0.6, -1.0), (1.2, 0.0, -1.0)):
        for direction in ((1.0, 0.0, 0.0), (0.0, 0.0, -1.0), (-DIAGONAL, DIAGONAL, 0.0)):
            assert cast(tank, origin, direction) == 0.0


def test_random_rays_end_where_marching_ends(make_tank: Make) -> None:
    """For 200 random rays the first point in 0.5 mm steps that is no water lies where the ray ends."""
    tank, draw, step = make_tank(BOUNDS, SPHERES, BOXES), np.random.default_rng(5), 5e-4
    reach = step * np.arange(16000)
    checked = 0
    while checked < 200:
        origin = draw.uniform(*BOUNDS)
        direction = draw.normal(size=3)
        direction /= np.linalg.norm(direction)
        wet = is_water(origin + reach[:, None] * direction)
        if not wet[0]:
            continue
        checked += 1
        assert cast(tank, origin, direction) == pytest.approx(reach[np.argmin(wet)], abs=1.5 * step)


def is_water(points: Any) -> Any:
    """Whether each of `points` (n, 3) is in the tank and in no solid, told point by point."""
    wet = ((points >= BOUNDS[0]) & (points <= BOUNDS[1])).all(axis=1)
    for *centre, radius in SPHERES:
        wet &= ((points - centre) ** 2).sum(axis=1) > radius**2
    for box in BOXES:
        wet &= ((points < box[:3]) | (points > box[3:])).any(axis=1)
    return wet
