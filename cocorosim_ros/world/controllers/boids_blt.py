"""Boids with blue-light triangulation (BLT): ranges by blue light, velocities by radio from everybody in range.

The rules and their sources stand in controllers.boids_rules.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.boids_rules import SETTINGS, say_velocity, swim_by_blue_light
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.state.observation import Observation


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen and heard on the radio into heading, speed and dive speed; all stay while the compass fails."""
    swim_by_blue_light(observation, observation.heard, observation.heard_count, sensor_axis, settings, request)


BOIDS_BLT = Controller(
    summary="boids with blue-light ranges and radio velocities",
    settings=SETTINGS,
    decide=decide,
    speak=say_velocity,
    payload_length=3,
)
