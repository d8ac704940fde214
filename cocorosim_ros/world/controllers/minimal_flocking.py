"""Flocking without communication: discrete turns by range thresholds, no velocities, nothing is said.

Each blue-light sensor is compared with thresholds, fractions of its range. Too near (separation): turn one step
away. Too far (cohesion): turn one step towards. In between: straight on. The threshold behind is larger than that
at the sides, so that a robot lets others follow it before it turns back: that asymmetry aligns the flock without
any rule for it. Up and down the same thresholds ask for one dive speed. Of several robots too near the nearest
counts, and separation goes before cohesion; of several too far the farthest counts. A robot dead astern is turned
to by the left.

Source: Moeslinger, Schmickl and Crailsheim, A minimalist flocking algorithm for swarm robots (ECAL 2009); the
numbers are those of the port in the released model of CoCoRoSim (cohesion 0.6, behind 0.8, separation 0.5 of the
range, 15-degree turns, 1 % thrust, 10 % alone). The original has four infrared sectors on the ground; how the
rules meet five cones in three dimensions is a choice made here.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.functions import (
    neighbours_in_sight,
    set_dive_speed,
    set_relative_heading,
    set_speed,
)
from cocorosim_ros.world.controllers.request import TURN_GAIN
from cocorosim_ros.world.state.observation import Observation

SETTINGS = (
    "sensor_range",
    "separation",
    "cohesion",
    "cohesion_behind",
    "turn",
    "speed",
    "lone_speed",
    "dive_speed",
    "turn_gain",
)
SENSOR_RANGE, SEPARATION, COHESION, COHESION_BEHIND = 0, 1, 2, 3
TURN, FLOCK_SPEED, LONE_SPEED, DIVE_SPEED, FLOCK_TURN_GAIN = 4, 5, 6, 7, 8
VERTICAL = 0.5  # a cone whose axis rises or falls by more than 30 degrees looks up or down
BEHIND = -0.5


@kernel
def urge(distance: float, axis: Floats, settings: Floats) -> float:
    """What a reading asks for: -1 away, +1 towards, 0 nothing."""
    if not math.isfinite(distance):
        return 0.0
    fraction = distance / settings[SENSOR_RANGE]
    if fraction < settings[SEPARATION]:
        return -1.0
    behind = axis[0] < BEHIND
    return 1.0 if fraction > (settings[COHESION_BEHIND] if behind else settings[COHESION]) else 0.0


@kernel
def decisive_sensor(observation: Observation, sensor_axis: Floats, settings: Floats, vertical: bool) -> int:
    """The sensor to act upon, -1 for none: the nearest of those too near, else the farthest of those too far."""
    chosen, best = -1, 0.0
    for sensor in range(sensor_axis.shape[0]):
        axis, distance = sensor_axis[sensor], observation.neighbour_range[sensor]
        wanted = urge(distance, axis, settings)
        if wanted == 0.0 or (abs(axis[2]) > VERTICAL) != vertical:
            continue
        if wanted < 0.0 and axis[0] < BEHIND:
            continue  # straight on leads away from who is behind
        fraction = distance / settings[SENSOR_RANGE]
        rank = fraction if wanted > 0.0 else 3.0 - fraction
        if rank > best:
            chosen, best = sensor, rank
    return chosen


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Turn and dive by one step where somebody is too near or too far."""
    alone = neighbours_in_sight(observation) == 0
    request[TURN_GAIN] = settings[FLOCK_TURN_GAIN]
    set_speed(request, settings[LONE_SPEED] if alone else settings[FLOCK_SPEED])
    level = decisive_sensor(observation, sensor_axis, settings, False)
    if level >= 0:
        axis = sensor_axis[level]
        side = 1.0 if axis[1] > 0.0 or axis[0] < BEHIND else -1.0
        turn = side * urge(observation.neighbour_range[level], axis, settings) * settings[TURN]
        set_relative_heading(request, observation.compass, turn)
    upright = decisive_sensor(observation, sensor_axis, settings, True)
    climb = 0.0
    if upright >= 0:
        axis = sensor_axis[upright]
        climb = math.copysign(settings[DIVE_SPEED], axis[2])
        climb *= urge(observation.neighbour_range[upright], axis, settings)
    set_dive_speed(request, climb)


MINIMAL_FLOCKING = Controller(
    summary="flocking by range thresholds, without communication",
    settings=SETTINGS,
    decide=decide,
)
