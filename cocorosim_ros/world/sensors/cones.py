"""The cones of blue-light sensors in vectors, so that a robot looks through eight of them at once."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES
from cocorosim_ros.world.sensors.instruments import Instruments

HALVES = 2  # vectors side by side: a processor does not wait for the one while it is at the other
AXIS, COSINE, REACH, CONE_SIZE = 0, 3, 4, 5  # numbers of a cone: unit vector [body], of half its angle, range [m]


def cones_of(instruments: Instruments) -> Floats:
    """(robots, eights, HALVES, CONE_SIZE, LANES) the cones of every robot, sensor by sensor; lanes left see nothing."""
    robots, sensors = instruments.neighbour_range.shape
    eights = -(-sensors // (HALVES * LANES))
    cones = np.zeros((robots, eights * HALVES * LANES, CONE_SIZE))
    cones[..., REACH] = -1.0
    cones[:, :sensors, AXIS:COSINE] = instruments.axis
    cones[:, :sensors, COSINE] = instruments.cosine_half_angle
    cones[:, :sensors, REACH] = instruments.neighbour_range
    return np.ascontiguousarray(cones.reshape(robots, eights, HALVES, LANES, CONE_SIZE).swapaxes(3, 4))
