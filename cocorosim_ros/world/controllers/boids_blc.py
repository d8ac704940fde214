"""Boids with blue-light communication (BLC): as BLT, but velocities go over blue light, to the nearest alone.

The radio stays free for other work. The rules and their sources stand in controllers.boids_rules, who hears whom in
links.blue_light.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.boids_rules import SETTINGS, say_velocity, swim_by_blue_light
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.state.observation import Observation


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen and heard by light into heading, speed and dive speed; all stay while the compass fails."""
    swim_by_blue_light(observation, observation.light, observation.light_count, sensor_axis, settings, request)


BOIDS_BLC = Controller(
    summary="boids with blue-light ranges and velocities over blue light",
    settings=SETTINGS,
    decide=decide,
    speak=say_velocity,
    payload_length=3,
    medium="blue_light",
    needs=("blue_light_rx",),
)
