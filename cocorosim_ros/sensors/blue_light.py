r"""Blue-light sensors (BLSS): the nearest robot in a cone, and obstacles along three rays.

Seen from above, Lily's three sensors in the plane (cones of 120 degrees; two more look up and down):

                 +60 front_left
                  \\      forward
          back ----o---->  x
                  /
                 -60 front_right

A robot is in the cone when the angle between its direction and the cone's axis is at most half the cone;
among those within range the nearest counts, as in the paper. An obstacle's range is the shortest of the rays
along the cone's centre and limits. Assumes: robots neither hide each other nor obstacles; no noise.
Source: Read et al. 2013, section 2.1.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.compilation import kernel, stack_array
from cocorosim_ros.environment.tank import Tank, is_open_water, ray_range
from cocorosim_ros.sensors.instruments import Instruments
from cocorosim_ros.signals.angles import sine_cosine
from cocorosim_ros.signals.state import YAW, X, Y, Z

Floats = NDArray[np.float64]
Integers = NDArray[np.int32]


@kernel
def neighbour_ranges(
    states: Floats, robot: int, nearby: Integers, instruments: Instruments, reading: Floats, nearest: NDArray[np.int64]
) -> None:
    """Write the range [m] of the nearest robot in each cone of `robot` into `reading` (sensors,).

    `states` (robots, columns) are all robots of one run, `nearby` the numbers of those that may be in range;
    +inf where a cone is empty. Who it is stands in `nearest` (sensors,), -1 for nobody: blue light carries messages
    to and from there.
    """
    row = states[robot]
    sine, cosine = sine_cosine(row[YAW])
    sensors = reading.shape[0]
    for sensor in range(sensors):
        reading[sensor] = math.inf
        nearest[sensor] = -1
    for other in nearby:
        east, north = states[other, X] - row[X], states[other, Y] - row[Y]
        up = states[other, Z] - row[Z]
        distance = math.sqrt(east * east + north * north + up * up)
        forward, left = east * cosine + north * sine, north * cosine - east * sine
        # No branch on what is measured: in a shoal a processor would guess every other one wrong.
        for sensor in range(sensors):
            axis, yet, who = instruments.axis[robot, sensor], reading[sensor], nearest[sensor]
            along = forward * axis[0] + left * axis[1] + up * axis[2]
            seen = (distance <= instruments.neighbour_range[robot, sensor]) & (distance < yet)
            seen &= along >= distance * instruments.cosine_half_angle[robot, sensor]
            reading[sensor] = distance if seen else yet
            nearest[sensor] = other if seen else who


@kernel
def obstacle_ranges(row: Floats, robot: int, instruments: Instruments, tank: Tank, reading: Floats) -> None:
    """Write the shortest ray [m] of each sensor of `robot` into `reading` (sensors,); +inf beyond range."""
    reach = 0.0
    for sensor in range(reading.shape[0]):
        reading[sensor] = math.inf
        reach = max(reach, instruments.obstacle_range[robot, sensor])
    if is_open_water(tank, row[X : Z + 1], reach):
        return
    sine, cosine = sine_cosine(row[YAW])
    origin, direction = row[X : Z + 1], stack_array(3)
    for sensor in range(reading.shape[0]):
        nearest = math.inf
        for index in range(instruments.ray_count[robot, sensor]):
            ray = instruments.ray[robot, sensor, index]
            direction[0] = ray[0] * cosine - ray[1] * sine
            direction[1] = ray[0] * sine + ray[1] * cosine
            direction[2] = ray[2]
            nearest = min(nearest, ray_range(tank, origin, direction, instruments.obstacle_range[robot, sensor]))
        reading[sensor] = nearest if nearest <= instruments.obstacle_range[robot, sensor] else math.inf
