"""Scales of a platform: its full speed, the time over which it coasts, and what a metre of its water weighs."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE

FORWARD, LEFT, UP, TURN = range(4)
"""Columns of a platform's wrenches: forces along the axes of the body, and the moment about z."""
AHEAD = slice(0, 1)
"""The column of a platform's limits that holds the force at command +1, as a matrix of one column."""


def full_speed(platform: Platform) -> float:
    """Speed v [m/s] at which quadratic drag holds all horizontal thrust: v = sqrt(X / k)."""
    thrust = np.abs(platform.actuator_wrenches()[:, FORWARD:UP]) * platform.full_forces().max(axis=1, keepdims=True)
    return float(np.sqrt(thrust.sum(axis=0).max(initial=0.0) / max(platform.drag, 1e-9)))


def coasting_time(platform: Platform) -> float:
    """Time m / (k v) [s] in which a platform loses half of its full speed v; 0 without thrust or without drag."""
    braking = platform.drag * full_speed(platform)
    return platform.mass / braking if braking > 0.0 else 0.0


def pressure_per_metre(platform: Platform, log: RobotLog) -> float:
    """Pressure [Pa/m] that a log shows for each metre of depth: what the platform's water weighs.

    Pressures that a map made of depths are by the contract's fresh water.
    """
    stream = log.streams.get("pressure")
    if stream is not None and stream.from_depth:
        return PASCAL_PER_METRE
    return platform.water_density * platform.gravity
