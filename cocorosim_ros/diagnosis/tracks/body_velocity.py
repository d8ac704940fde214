"""Velocities of states in the robot's own axes: through the water and over ground, roll and pitch as recorded.

The models of a diagnosis move along level axes. With the rotation R from body axes to level ones a velocity V there is
R^T V along the robot's own, and it turns about its own upward axis as `Attitude.own_turn_rate` says; a robot whose roll
and pitch were not recorded counts as level.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.findings import BodyVelocity
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.motion.dynamics import relative_velocity
from cocorosim_ros.world.state.state import SURGE, YAW_RATE


def through_water(track: Track, moments: Floats, states: Floats, row: Floats) -> Floats:
    """Velocities through the water (n, 4) [m/s, rad/s; level axes] in states (n, 8 or more) at moments (n,) [s].

    row (columns,): the numbers of the model, whose water may move.
    """
    water, body = np.zeros((len(moments), 4)), track.actuation.vehicle.body(row)
    for time, each, relative in zip(moments, np.ascontiguousarray(states), water, strict=True):
        relative_velocity(each, time, body, relative)
    return water


def body_velocity(track: Track, moments: Floats, states: Floats, row: Floats) -> BodyVelocity:
    """Velocities in the robot's own axes of states (n, 8 or more) at moments (n,) [s]; row as in `through_water`."""
    relative = through_water(track, moments, states, row)
    ground = states[:, SURGE : YAW_RATE + 1]
    return BodyVelocity(_in_body(track, moments, relative), _in_body(track, moments, ground))


def _in_body(track: Track, moments: Floats, level: Floats) -> Floats:
    """Turn velocities (n, 4) from level axes into the robot's own."""
    attitude = track.log.attitude
    if attitude is None:
        return level.copy()
    *speeds, heading_rate = level.T
    along = np.einsum("nji,jn->ni", attitude.turns(moments), np.array(speeds))
    return np.column_stack([along, attitude.own_turn_rate(moments, heading_rate)])
