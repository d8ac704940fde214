"""The tank as numbers: four walls, a floor, the surface, and solid spheres and boxes in between.

Assumes: axis-aligned boxes; rays start in the water.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel

SAFE_DISTANCE = 1e-6  # m, more than the rounding of any ray


class Tank(NamedTuple):
    """Where water ends."""

    lower: Floats  # (3,) lowest corner [m; world]; z is the floor
    upper: Floats  # (3,) highest corner [m; world]; z = 0 is the surface
    spheres: Floats  # (spheres, 4) centre and radius [m; world]
    boxes: Floats  # (boxes, 6) lowest and highest corner [m; world]


@kernel
def _box_entry(origin: Floats, direction: Floats, box: Floats) -> float:
    """Distance [m] along a ray to the outside of a box, +inf if it misses (slab method)."""
    near, far = 0.0, math.inf
    for axis in range(3):
        if direction[axis] == 0.0:
            if origin[axis] < box[axis] or origin[axis] > box[axis + 3]:
                return math.inf
            continue
        first = (box[axis] - origin[axis]) / direction[axis]
        second = (box[axis + 3] - origin[axis]) / direction[axis]
        near = max(near, min(first, second))
        far = min(far, max(first, second))
    return near if near <= far else math.inf


@kernel
def _sphere_entry(origin: Floats, direction: Floats, sphere: Floats) -> float:
    """Distance [m] along a unit ray to a sphere, +inf if it misses, 0 from within."""
    along, squared = 0.0, 0.0
    for axis in range(3):
        offset = sphere[axis] - origin[axis]
        along += offset * direction[axis]
        squared += offset * offset
    clearance = squared - sphere[3] * sphere[3]
    if clearance <= 0.0:
        return 0.0
    reach = along * along - clearance
    if along < 0.0 or reach < 0.0:
        return math.inf
    return along - math.sqrt(reach)


@kernel
def ray_range(tank: Tank, origin: Floats, direction: Floats, reach: float) -> float:
    """Distance [m] from `origin` (3,) along the unit vector `direction` (3,) to the first solid or the surface.

    Both in the world frame. Zero where the origin is not in the water. What is farther than `reach` [m] may be left
    out: then it is +inf. A division takes longer than to see that it is not needed.
    """
    distance, farthest = math.inf, reach + SAFE_DISTANCE
    for axis in range(3):
        if direction[axis] > 0.0:
            clearance = tank.upper[axis] - origin[axis]
            if clearance <= direction[axis] * farthest:
                distance = min(distance, clearance / direction[axis])
        elif direction[axis] < 0.0:
            clearance = tank.lower[axis] - origin[axis]
            if clearance >= direction[axis] * farthest:
                distance = min(distance, clearance / direction[axis])
    for index in range(tank.spheres.shape[0]):
        distance = min(distance, _sphere_entry(origin, direction, tank.spheres[index]))
    for index in range(tank.boxes.shape[0]):
        distance = min(distance, _box_entry(origin, direction, tank.boxes[index]))
    return distance if distance > 0.0 else 0.0


@kernel
def is_open_water(tank: Tank, origin: Floats, reach: float) -> bool:
    """Whether surely nothing solid, nor the surface, lies within `reach` [m] of `origin` (3,) [m; world].

    Spares the rays of those who swim freely. False is no promise of the contrary.
    """
    reach += SAFE_DISTANCE
    for axis in range(3):
        if not (tank.lower[axis] + reach < origin[axis] < tank.upper[axis] - reach):
            return False
    for index in range(tank.spheres.shape[0]):
        sphere = tank.spheres[index]
        x, y, z = sphere[0] - origin[0], sphere[1] - origin[1], sphere[2] - origin[2]
        if not x * x + y * y + z * z > (sphere[3] + reach) ** 2:
            return False
    for index in range(tank.boxes.shape[0]):
        box, apart = tank.boxes[index], False
        for axis in range(3):
            apart = apart or origin[axis] + reach < box[axis] or origin[axis] - reach > box[axis + 3]
        if not apart:
            return False
    return True
