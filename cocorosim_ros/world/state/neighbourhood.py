"""The exact places of the robots near each robot: what the simulation knows and no real robot does."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers


class Neighbourhood(NamedTuple):
    """Who is within range of whom at one tick; leading axes (runs, robots)."""

    found: Integers  # (runs, robots) neighbours
    who: Integers  # (runs, robots, capacity) index of the neighbour, ascending
    offset: Floats  # (runs, robots, capacity, 3) from the robot to the neighbour [m; body]
    velocity: Floats  # (runs, robots, capacity, 3) of the neighbour over ground [m/s; world]


def empty_neighbourhood(runs: int, robots: int, capacity: int) -> Neighbourhood:
    """A neighbourhood in which everybody is alone."""
    return Neighbourhood(
        found=np.zeros((runs, robots), dtype=np.int64),
        who=np.zeros((runs, robots, capacity), dtype=np.int64),
        offset=np.zeros((runs, robots, capacity, 3)),
        velocity=np.zeros((runs, robots, capacity, 3)),
    )
