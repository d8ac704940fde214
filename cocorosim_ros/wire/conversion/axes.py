"""North-east-down and forward-right-down to east-north-up and forward-left-up, as REP 103 has them."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats

_HALF = math.sqrt(0.5)
_NED_TO_ENU = np.array([_HALF, _HALF, 0.0, 0.0])  # half a turn about the line between north and east
_FLU_TO_FRD = np.array([1.0, 0.0, 0.0, 0.0])  # half a turn about the forward axis


def world_from_ned(position: Floats) -> Floats:
    """(n, 3) east, north, up of (n, 3) north, east, down."""
    return position[:, [1, 0, 2]] * [1.0, 1.0, -1.0]


def body_from_frd(vector: Floats) -> Floats:
    """(n, 3) forward, left, up of (n, 3) forward, right, down."""
    return vector * [1.0, -1.0, -1.0]


def attitude_from_ned(quaternion: Floats) -> Floats:
    """(n, 4) attitude x y z w of forward-left-up in east-north-up, from forward-right-down in north-east-down."""
    return product(product(_NED_TO_ENU[None], quaternion), _FLU_TO_FRD[None])


def heading_from_ned(heading: Floats) -> Floats:
    """(n,) counter-clockwise from east, from clockwise from north [rad]."""
    return np.asarray(math.pi / 2 - heading)


def wrap(angle: Floats) -> Floats:
    """(n,) the same directions in (-pi, pi]; angles that are there already stay as they are."""
    wrapped = math.pi - np.mod(math.pi - angle, 2 * math.pi)
    return np.where((angle > -math.pi) & (angle <= math.pi), angle, wrapped)


def quaternion(roll: Floats, pitch: Floats, yaw: Floats) -> Floats:
    """(n, 4) x y z w of a turn by yaw, then pitch, then roll about the axes so turned [rad]."""
    turns = np.zeros((3, len(yaw), 4))
    for axis, angle in enumerate((roll, pitch, yaw)):
        turns[axis, :, axis], turns[axis, :, 3] = np.sin(angle / 2), np.cos(angle / 2)
    return product(product(turns[2], turns[1]), turns[0])


def product(first: Floats, second: Floats) -> Floats:
    """(n, 4) Hamilton product of quaternions x y z w."""
    x1, y1, z1, w1 = first.T
    x2, y2, z2, w2 = second.T
    return np.column_stack(
        [
            w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
            w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
        ]
    )
