"""The true state of a vehicle in six degrees of freedom: one row of 13 numbers, columns named here.

Position and attitude are those of the origin of the body axes in the world (REP 103: east-north-up, body axes
forward-left-up); velocities are over ground, in body axes: Fossen's nu with the axes of REP 103.
"""

from __future__ import annotations

X = 0  # x, y, z: m, world
ATTITUDE = 3  # unit quaternion x, y, z, w: turns vectors of the body into those of the world
SURGE = 7  # u, v, w: m/s, body
ROLL_RATE = 10  # p, q, r: rad/s, body
STATE_SIZE = 13
