"""Swims along one heading at one speed and depth with the operating system's own functions."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.request import DIVE, DIVE_MODE, DIVE_TO_DEPTH, HEADING, SPEED, TURN_GAIN
from cocorosim_ros.world.state.observation import Observation


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for the heading, speed and depth of the settings."""
    request[HEADING] = settings[0]
    request[SPEED] = settings[1]
    request[DIVE_MODE] = DIVE_TO_DEPTH
    request[DIVE] = settings[2]
    request[TURN_GAIN] = settings[3]


HEADING_HOLD = Controller(
    summary="one heading, one speed, one depth",
    settings=("heading", "speed", "depth", "turn_gain"),
    decide=decide,
)
