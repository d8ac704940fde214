"""Rough scales of a platform: its full speed, and the time over which it coasts."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.scenario.parts.platform import Platform

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
