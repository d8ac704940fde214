"""What surrounds one robot throughout a recording: where its water ends, and who else swims there."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.terms.moment import NEIGHBOUR_SIZE

FAR = 1e6  # m: where the water ends as long as nothing tells


class RecordedSurroundings(NamedTuple):
    """Corners of the water, and all robots of the recording at every grid point."""

    lower: Floats  # (3,) lowest corner [m; world]
    upper: Floats  # (3,) highest corner [m; world]
    around: Floats  # (points, robots, NEIGHBOUR_SIZE) places and thrusts; (1, 0, NEIGHBOUR_SIZE) for a robot alone
    own: int  # the robot's own row among these; -1 for a robot alone


OPEN_WATER = RecordedSurroundings(np.full(3, -FAR), np.full(3, FAR), np.zeros((1, 0, NEIGHBOUR_SIZE)), -1)
