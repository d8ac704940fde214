"""The functions that the robot's operating system offers a behaviour, by the names the paper gives them.

Each writes into `request` (controllers.request), which the operating system carries out until it is changed:
absolute and relative heading, speed, depth, dive speed, direct actuators; `heading_achieved` and the two counts of
neighbours answer questions. Obstacle avoidance is not asked for: it overrides the behaviour (controllers.conduct).
Source: Read et al. 2013, section 2.1; cocorosim-facts 1.4 for the list.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.request import (
    DIRECT,
    DIVE,
    DIVE_AT_SPEED,
    DIVE_MODE,
    DIVE_TO_DEPTH,
    FRACTIONS,
    HEADING,
    SPEED,
)
from cocorosim_ros.world.state.observation import Observation


@kernel
def set_absolute_heading(request: Floats, heading: float) -> None:
    """Turn to `heading` [rad; world] and keep it."""
    request[DIRECT] = 0.0
    request[HEADING] = wrap_angle(heading)


@kernel
def set_relative_heading(request: Floats, compass: float, turn: float) -> None:
    """Turn by `turn` [rad, left positive] from the present `compass` [rad; world]; nothing while that is not known."""
    if math.isfinite(compass):
        set_absolute_heading(request, compass + turn)


@kernel
def set_speed(request: Floats, fraction: float) -> None:
    """Swim with this fraction of the full thrust, -1..1, backwards where it is negative, as the paper's text has it."""
    request[DIRECT] = 0.0
    request[SPEED] = min(max(fraction, -1.0), 1.0)


@kernel
def set_depth(request: Floats, depth: float) -> None:
    """Go to `depth` [m, down positive] and keep it."""
    request[DIRECT] = 0.0
    request[DIVE_MODE] = DIVE_TO_DEPTH
    request[DIVE] = depth


@kernel
def set_dive_speed(request: Floats, climb: float) -> None:
    """Rise with `climb` [m/s, up positive]."""
    request[DIRECT] = 0.0
    request[DIVE_MODE] = DIVE_AT_SPEED
    request[DIVE] = climb


@kernel
def set_actuator(request: Floats, actuator: int, fraction: float) -> None:
    """Command the platform's `actuator`-th actuator directly, -1..1; heading, depth and avoidance are off."""
    request[DIRECT] = 1.0
    request[FRACTIONS + actuator] = min(max(fraction, -1.0), 1.0)


@kernel
def heading_achieved(request: Floats, compass: float, tolerance: float) -> bool:
    """Whether the compass [rad] is within `tolerance` [rad] of the heading asked for."""
    achieved: bool = abs(wrap_angle(request[HEADING] - compass)) <= tolerance
    return achieved


@kernel
def neighbours_in_sight(observation: Observation) -> int:
    """How many blue-light sensors see a robot."""
    count = 0
    for sensor in range(observation.neighbour_range.shape[0]):
        if math.isfinite(observation.neighbour_range[sensor]):
            count += 1
    return count


@kernel
def neighbours_on_radio(observation: Observation) -> int:
    """How many messages came in by radio since the last cycle."""
    return observation.heard_count
