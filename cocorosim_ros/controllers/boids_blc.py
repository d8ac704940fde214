"""Boids with blue-light communication (BLC): as BLT, but velocities go over blue light, to the nearest alone.

The radio stays free for other work. The rules and their sources stand in controllers.boids_rules, who hears whom in
media.blue_light.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.compilation import kernel, stack_array
from cocorosim_ros.controllers.boids_rules import (
    SETTINGS,
    add_alignment,
    add_range_rules,
    median_heard_velocity,
    say_velocity,
    swim_alone,
    swim_as_wished,
    take_up_boids,
    weight_total,
)
from cocorosim_ros.controllers.controller import Controller
from cocorosim_ros.signals.observation import Observation

Floats = NDArray[np.float64]


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen and heard by light into heading, speed and dive speed; all stay while the compass fails."""
    take_up_boids(settings, request)
    if math.isnan(observation.compass):
        return
    wish, velocity = stack_array(3), stack_array(3)
    seen = add_range_rules(observation, sensor_axis, settings, wish)
    heard = median_heard_velocity(observation.light, observation.light_count, velocity)
    if seen + heard == 0:
        swim_alone(settings, request)
        return
    add_alignment(observation.compass, velocity, settings, wish)
    swim_as_wished(observation.compass, wish, weight_total(settings), settings, request)


BOIDS_BLC = Controller(
    summary="boids with blue-light ranges and velocities over blue light",
    settings=SETTINGS,
    decide=decide,
    speak=say_velocity,
    payload_length=3,
    medium="blue_light",
    needs=("blue_light_rx",),
)
