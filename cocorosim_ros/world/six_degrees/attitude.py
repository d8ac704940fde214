"""Attitudes as unit quaternions x, y, z, w that turn vectors of the body into those of the world.

Nothing here is singular, and nothing but products and a square root is needed, so that a result has the same bits on
every machine. Source: Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2021), section 2.2.2.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def to_world(attitude: Floats, body: Floats, world: Floats) -> None:
    """Write `world` (3,), the vector of which `body` (3,) has the body's axes; `attitude` (4,) is of unit length.

    v' = v + 2 w (e x v) + 2 e x (e x v), with the quaternion's vector e and scalar w.
    """
    _turn(attitude, 1.0, body, world)


@kernel
def to_body(attitude: Floats, world: Floats, body: Floats) -> None:
    """Write `body` (3,), the vector of which `world` (3,) has the world's axes; see `to_world`."""
    _turn(attitude, -1.0, world, body)


@kernel
def _turn(attitude: Floats, sense: float, given: Floats, turned: Floats) -> None:
    x, y, z, w = sense * attitude[0], sense * attitude[1], sense * attitude[2], attitude[3]
    first = 2.0 * (y * given[2] - z * given[1])
    second = 2.0 * (z * given[0] - x * given[2])
    third = 2.0 * (x * given[1] - y * given[0])
    turned[0] = given[0] + w * first + (y * third - z * second)
    turned[1] = given[1] + w * second + (z * first - x * third)
    turned[2] = given[2] + w * third + (x * second - y * first)


@kernel
def attitude_rate(attitude: Floats, rate: Floats, result: Floats) -> None:
    """Write the derivative (4,) [1/s] of a quaternion under the body's angular velocity `rate` (3,) [rad/s; body].

    q_dot = q (p, q, r, 0) / 2, the product of quaternions.
    """
    x, y, z, w = attitude[0], attitude[1], attitude[2], attitude[3]
    result[0] = 0.5 * (w * rate[0] + y * rate[2] - z * rate[1])
    result[1] = 0.5 * (w * rate[1] + z * rate[0] - x * rate[2])
    result[2] = 0.5 * (w * rate[2] + x * rate[1] - y * rate[0])
    result[3] = -0.5 * (x * rate[0] + y * rate[1] + z * rate[2])


@kernel
def bring_to_unit_length(attitude: Floats) -> None:
    """Scale a quaternion (4,) to unit length, which steps in time leave by their own error."""
    square = 0.0
    for part in range(4):
        square += attitude[part] * attitude[part]
    scale = 1.0 / math.sqrt(square)
    for part in range(4):
        attitude[part] *= scale


def attitude_of(roll: float, pitch: float, yaw: float) -> Floats:
    """(4,) the quaternion of angles [rad] about fixed axes x, then y, then z of the world (REP 103).

    A positive pitch brings the bow down, since y points to the left.
    """
    quaternion = np.array([0.0, 0.0, 0.0, 1.0])
    for axis, angle in ((2, yaw), (1, pitch), (0, roll)):
        turn = np.zeros(4)
        turn[axis], turn[3] = math.sin(angle / 2), math.cos(angle / 2)
        quaternion = _product(quaternion, turn)
    return quaternion


def angles_of(attitude: Floats) -> tuple[Floats, Floats, Floats]:
    """Roll, pitch and yaw [rad], each (...), of quaternions (..., 4), the inverse of `attitude_of`.

    Pitch lies within +-90 deg; where it is 90 deg exactly roll and yaw are not known apart.
    """
    x, y, z, w = (attitude[..., part].copy() for part in range(4))
    roll = np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = np.arcsin(np.clip(2 * (w * y - z * x), -1.0, 1.0))
    yaw = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return roll, pitch, yaw


def _product(first: Floats, second: Floats) -> Floats:
    vector = first[3] * second[:3] + second[3] * first[:3] + np.cross(first[:3], second[:3])
    return np.append(vector, first[3] * second[3] - first[:3] @ second[:3])
