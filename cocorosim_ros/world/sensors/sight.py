"""What one robot's sensors have before them at one moment."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.world.sensors.instruments import Instruments
from cocorosim_ros.world.surroundings.lamps import Lamps
from cocorosim_ros.world.surroundings.tank import Tank

Robots = NDArray[np.int32]


class Sight(NamedTuple):
    """One robot at one moment, for compiled loops."""

    states: Floats  # (robots, columns) of all robots of the run, see state.state
    robot: int  # its number among them
    row: Floats  # (columns,) its own state
    rate: Floats  # (STATE_SIZE,) rate of its state
    relative: Floats  # (4,) u v w r through the water [m/s, rad/s; body]
    instruments: Instruments
    tank: Tank
    lamps: Lamps
    cones: Floats  # of the blue-light sensors of all robots, see sensors.cones
    nearby: Robots  # numbers of the robots that may be in range
    nearest: Integers  # (blue-light sensors,) receives the nearest robot in each cone, -1 for none
    concentration: float  # of the plume's substance [kg/m^3]
