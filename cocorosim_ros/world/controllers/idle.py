"""Does nothing: all actuators off."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.request import DIRECT
from cocorosim_ros.world.state.observation import Observation

Floats = NDArray[np.float64]


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for zero of every actuator."""
    request[:] = 0.0
    request[DIRECT] = 1.0


IDLE = Controller(summary="all actuators off", settings=(), decide=decide)
