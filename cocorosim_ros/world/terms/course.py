"""One robot over time, as a recording shows it: what regressors are computed from, all moments at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.state.state import X, Z


class Course(NamedTuple):
    """State, actuators and surroundings of one robot at equally spaced moments, the grid points."""

    time: Floats  # (points,) [s]
    state: Floats  # (points, 8 or more) x y z yaw u v w r, in the order of state.state
    thrust: Floats  # (points, 4) wrench of the thrusters [N, N, N, N m; body], means until the next point
    force: Floats  # (points, actuators) [N], means until the next point
    rate: Floats  # (points, actuators) [N/s], means until the next point
    is_pump: Flags  # (actuators,)
    water: tuple[Floats, Floats]  # lowest and highest corner [m; world]
    neighbours: Floats  # (points or 1, robots, 3 or more) places [m; world] of all robots
    own: int  # number of the robot itself among them, -1 if it is not


def motor_effort(course: Course) -> Floats:
    """(points,) what all thrusters deliver [N], each by its own amount: the currents of their motors follow it."""
    return np.asarray(np.abs(course.force[:, ~course.is_pump]).sum(axis=1))


def pump_along(course: Course, of: Floats) -> Floats:
    """(points,) the share of the pumps in what all actuators have, `of` (points, actuators)."""
    return np.asarray(of[:, course.is_pump].sum(axis=1))


def clearance_along(course: Course) -> Floats:
    """(points,) distance to the nearest of walls, floor and surface [m], 0 beyond them."""
    place, (lower, upper) = course.state[:, X : Z + 1], course.water
    return np.asarray(np.maximum(np.minimum(place - lower, upper - place).min(axis=1), 0.0))


def neighbour_distance_along(course: Course) -> Floats:
    """(points,) distance to the nearest neighbour [m], +inf where there is none."""
    offset = course.neighbours[:, :, :3] - course.state[:, None, X : Z + 1]
    distance = np.linalg.norm(offset, axis=2)
    if course.own >= 0:
        distance[:, course.own] = np.inf
    return np.asarray(distance.min(axis=1, initial=np.inf))
