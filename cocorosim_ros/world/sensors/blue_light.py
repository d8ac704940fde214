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
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.four import LANES, chosen, four, in_fours, lanes
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.world.sensors.cones import AXIS, COSINE, HALVES, REACH
from cocorosim_ros.world.sensors.instruments import Instruments
from cocorosim_ros.world.sensors.sensor import PER_CONE, Elements, Field, Layout, Sensor
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.state import YAW, X, Y, Z
from cocorosim_ros.world.surroundings.tank import Tank, is_open_water, ray_range

Robots = NDArray[np.int32]
RANGES = ("neighbour_range", "obstacle_range")
NOWHERE, NOBODY = math.inf, -1.0


class Other(NamedTuple):
    """Another robot as seen from one: its place [m; body], its distance [m] and its number."""

    forward: float
    left: float
    up: float
    distance: float
    number: float


class Nearest(NamedTuple):
    """Ranges [m] and numbers of the nearest robots in four cones, as fours (compiling.four)."""

    ranges: Any
    numbers: Any


@kernel
def _look(cones: Floats, other: Other, found: Nearest) -> Nearest:
    """Look for one robot through four cones: what was `found` in them until now, or that robot where it is nearer.

    `cones` (CONE_SIZE,) of fours. No branch on what is measured: in a shoal a processor would guess every other one
    wrong.
    """
    distance, number = other.distance, other.number
    range_here = four(distance, distance, distance, distance)
    along = other.forward * cones[AXIS] + other.left * cones[AXIS + 1] + other.up * cones[AXIS + 2]
    shown = chosen(along >= range_here * cones[COSINE], range_here, NOWHERE)
    shown = chosen(range_here <= cones[REACH], shown, NOWHERE)
    nearer = shown < found.ranges
    numbers = chosen(nearer, four(number, number, number, number), found.numbers)
    return Nearest(chosen(nearer, shown, found.ranges), numbers)


@kernel
def _write_down(found: Nearest, first: int, reading: Floats, nearest: Integers) -> None:
    """Write what was found in four cones, the first of which is that of sensor `first`."""
    ranges, numbers = lanes(found.ranges), lanes(found.numbers)
    for lane in range(min(LANES, reading.shape[0] - first)):
        reading[first + lane] = ranges[lane]
        nearest[first + lane] = int(numbers[lane])


@kernel
def neighbour_ranges(
    states: Floats, robot: int, nearby: Robots, cones: Floats, reading: Floats, nearest: Integers
) -> None:
    """Write the range [m] of the nearest robot in each cone of `robot` into `reading` (sensors,).

    `states` (robots, columns) are all robots of one run, `nearby` the numbers of those that may be in range, `cones`
    those of all robots (see sensors.cones); +inf where a cone is empty. Who it is stands in `nearest` (sensors,), -1
    for nobody: blue light carries messages to and from there.
    """
    row = states[robot]
    x, y, z = row[X], row[Y], row[Z]
    sine, cosine = sine_cosine(row[YAW])
    nothing = Nearest(four(NOWHERE, NOWHERE, NOWHERE, NOWHERE), four(NOBODY, NOBODY, NOBODY, NOBODY))
    fours = in_fours(cones)
    for eight in range(cones.shape[1]):
        left_half, right_half = nothing, nothing
        for number in nearby:
            east, north, up = states[number, X] - x, states[number, Y] - y, states[number, Z] - z
            distance = math.sqrt(east * east + north * north + up * up)
            forward, left = east * cosine + north * sine, north * cosine - east * sine
            other = Other(forward, left, up, distance, float(number))
            left_half = _look(fours[robot, eight, 0], other, left_half)
            right_half = _look(fours[robot, eight, 1], other, right_half)
        _write_down(left_half, HALVES * LANES * eight, reading, nearest)
        _write_down(right_half, HALVES * LANES * eight + LANES, reading, nearest)


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


@kernel
def measure(sight: Sight, neighbour_range: Floats, obstacle_range: Floats) -> None:
    """Write both ranges (sensors,) [m] of one robot."""
    neighbour_ranges(sight.states, sight.robot, sight.nearby, sight.cones, neighbour_range, sight.nearest)
    obstacle_ranges(sight.row, sight.robot, sight.instruments, sight.tank, obstacle_range)


def _layout(sensors: tuple[BlueLightSensor, ...]) -> Layout:
    """Neighbour ranges of all sensors, then obstacle ranges [m]."""
    readings = [{"sensor": part.name, "azimuth": part.azimuth, "elevation": part.elevation} for part in sensors]
    places = [f"readings[{part.name}].{field}" for field in RANGES for part in sensors]
    return Layout(tuple(places), {"readings": readings})


def _ranges(message: Any) -> dict[str, float]:
    return {f"{part.sensor}.{name}": getattr(part, name) for part in message.readings for name in RANGES}


BLUE_LIGHT = Sensor(
    topic="blss",
    message="cocorosim_msgs/msg/BlssScan",
    meaning="what the blue-light sensors see",
    layout=_layout,
    fields=tuple(Field(name, "m", PER_CONE, channels={name: slice(None)}) for name in RANGES),
    measure=measure,
    optional=False,
    for_all=True,
    elements=Elements(_ranges, "m"),
)
