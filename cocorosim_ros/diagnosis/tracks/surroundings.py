"""Surroundings of one robot throughout a recording: the ends of its water, and the other robots in it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE

FAR = 1e6  # m: distance of walls and robots of which nothing is known


class RecordedSurroundings(NamedTuple):
    """Corners of the water, and all robots of the recording at every grid point."""

    lower: Floats  # (3,) lowest corner [m; world]
    upper: Floats  # (3,) highest corner [m; world]
    around: Floats  # (points, robots, NEIGHBOUR_SIZE) places and thrusts; (1, 0, NEIGHBOUR_SIZE) for a robot alone
    own: int  # number of the robot itself on the axis `robots`; -1 for a robot alone


OPEN_WATER = RecordedSurroundings(np.full(3, -FAR), np.full(3, FAR), np.zeros((1, 0, NEIGHBOUR_SIZE)), -1)
