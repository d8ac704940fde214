"""What happens at spheres and boxes in the water: the centre of a robot cannot be inside them.

A robot that a step took into an obstacle is put back to the nearest point of its surface. Assumes that a step is
shorter than an obstacle is thick (2 cm at Lily's top speed and steps of 0.25 s); obstacles that overlap are cleared in
the order of the scenario.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.motion.contact import INELASTIC
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, X, Y, Z
from cocorosim_ros.world.surroundings.tank import Tank


@kernel
def keep_out_of_obstacles(row: Floats, tank: Tank, contact: int) -> None:
    """Put one robot's state back into the water if a step took it into an obstacle."""
    for index in range(tank.spheres.shape[0]):
        _leave_sphere(row, tank.spheres[index], contact)
    for index in range(tank.boxes.shape[0]):
        _leave_box(row, tank, tank.boxes[index], contact)


@kernel
def _leave_sphere(row: Floats, sphere: Floats, contact: int) -> None:
    x, y, z = row[X] - sphere[0], row[Y] - sphere[1], row[Z] - sphere[2]
    distance = math.sqrt(x * x + y * y + z * z)
    if not 0.0 < distance < sphere[3]:
        return
    x, y, z = x / distance, y / distance, z / distance
    row[X], row[Y], row[Z] = sphere[0] + sphere[3] * x, sphere[1] + sphere[3] * y, sphere[2] + sphere[3] * z
    if contact == INELASTIC:
        _stop_against(row, x, y, z)


@kernel
def _leave_box(row: Floats, tank: Tank, box: Floats, contact: int) -> None:
    """Out through the nearest face that has water before it."""
    nearest, depth, side = -1, math.inf, 0
    for axis in range(3):
        below, above = row[X + axis] - box[axis], box[axis + 3] - row[X + axis]
        if below <= 0.0 or above <= 0.0:
            return
        if below < depth and box[axis] > tank.lower[axis]:
            nearest, depth, side = axis, below, -1
        if above < depth and box[axis + 3] < tank.upper[axis]:
            nearest, depth, side = axis, above, 1
    if nearest < 0:
        return
    row[X + nearest] = box[nearest] if side < 0 else box[nearest + 3]
    if contact == INELASTIC:
        _stop_against(row, side if nearest == 0 else 0.0, side if nearest == 1 else 0.0, side if nearest == 2 else 0.0)


@kernel
def _stop_against(row: Floats, x: float, y: float, z: float) -> None:
    """Take away the velocity against the outward normal (x, y, z) [1; world]."""
    sine, cosine = sine_cosine(row[YAW])
    surge, sway = x * cosine + y * sine, y * cosine - x * sine
    outward = row[SURGE] * surge + row[SWAY] * sway + row[HEAVE] * z
    if outward < 0.0:
        row[SURGE] -= outward * surge
        row[SWAY] -= outward * sway
        row[HEAVE] -= outward * z
