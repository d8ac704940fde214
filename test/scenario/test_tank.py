"""The tank and its obstacles."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.tank import Box, Sphere, Tank

TANK = Tank((6.0, 4.0, 2.0), (Sphere("ball", (1.0, 0.0, -1.0), 0.5), Box("block", (-1.0, 0.0, -1.5), (1.0, 2.0, 1.0))))


def test_walls_floor_and_surface_bound_the_water() -> None:
    """The water reaches to half the size sideways, and from the surface down."""
    assert TANK.lower_corner() == (-3.0, -2.0, -2.0)
    assert TANK.upper_corner() == (3.0, 2.0, 0.0)
    assert TANK.depth == 2.0
    assert TANK.contains((3.0, -2.0, 0.0))
    for outside in ((3.1, 0.0, -1.0), (0.0, -2.1, -1.0), (0.0, 0.0, 0.1), (0.0, 0.0, -2.1)):
        assert not TANK.contains(outside)


def test_obstacles() -> None:
    """A place inside a ball or block finds it, a place between finds none."""
    inside_ball, inside_block = TANK.obstacle_at((1.3, 0.3, -1.0)), TANK.obstacle_at((-1.4, 0.9, -1.1))
    assert inside_ball is not None and inside_ball.name == "ball"
    assert inside_block is not None and inside_block.name == "block"
    assert TANK.obstacle_at((1.4, 0.4, -1.0)) is None
    assert TANK.obstacle_at((-1.4, 1.1, -1.1)) is None
