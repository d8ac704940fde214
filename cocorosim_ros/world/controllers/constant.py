"""Commands the actuators with constant fractions: for calibration runs and closed forms."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.request import DIRECT, FRACTIONS
from cocorosim_ros.world.state.observation import Observation


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for the same fractions at every tick."""
    request[DIRECT] = 1.0
    for index in range(settings.shape[0]):
        request[FRACTIONS + index] = settings[index]


CONSTANT = Controller(
    summary="constant fractions of the first three actuators",
    settings=("first", "second", "third"),
    decide=decide,
)
