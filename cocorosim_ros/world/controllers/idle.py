"""Does nothing: all actuators off."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.request import DIRECT
from cocorosim_ros.world.state.observation import Observation


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for zero of every actuator."""
    request[:] = 0.0
    request[DIRECT] = 1.0


IDLE = Controller(summary="all actuators off", settings=(), decide=decide)
