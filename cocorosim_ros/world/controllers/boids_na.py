"""Boids without alignment (NA): ranges by blue light, no velocities, nothing is said.

The paper "effectively nullifies" the alignment rule and does not say whether its weight still divides the sum.
With `keep_divisor` it does: the shoal is then slower for that reason alone (12 instead of 2 below the fraction).
Source: Read et al. 2013, section 5; the rules stand in controllers.boids_rules.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.controllers.boids_rules import (
    ALIGNMENT_WEIGHT,
    SETTINGS,
    add_range_rules,
    swim_alone,
    swim_as_wished,
    take_up_boids,
    weight_total,
)
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.state.observation import Observation

KEEP_DIVISOR = len(SETTINGS)


@kernel
def total_without_alignment(settings: Floats, keep_divisor: int) -> float:
    """The sum of the weights, less that of alignment unless the setting at index `keep_divisor` is on."""
    total: float = weight_total(settings)
    if settings[keep_divisor] == 0.0:
        total -= settings[ALIGNMENT_WEIGHT]
    return total


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn what is seen into heading, speed and dive speed; all stay while the compass fails."""
    take_up_boids(settings, request)
    if math.isnan(observation.compass):
        return
    wish = stack_array(3)
    if add_range_rules(observation, sensor_axis, settings, wish) == 0:
        swim_alone(settings, request)
        return
    swim_as_wished(observation.compass, wish, total_without_alignment(settings, KEEP_DIVISOR), settings, request)


BOIDS_NA = Controller(
    summary="boids with blue-light ranges and no alignment",
    settings=(*SETTINGS, "keep_divisor"),
    decide=decide,
)
