"""Who takes part, and the directions in which the robots point and travel."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.four import LANES, chosen
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.four_runs import flags, four_of, in_all, list_runs, numbers, put_coordinate
from cocorosim_ros.study.metrics.swarms import ALL, Swarms


@kernel
def fill_presence(swarms: Swarms, yaw: Floats, said: Flags) -> None:
    """Fill `members[ALL]` (those said to be present whose pose is finite) and `movers[ALL]`."""
    position, before = swarms.position, swarms.memory.present
    members, movers = swarms.members[ALL], swarms.movers[ALL]
    for run in range(yaw.shape[0]):
        for i in range(yaw.shape[1]):
            # A sum is finite only if its terms are, unless they overflow: no tank is that large.
            total = position[run, i, 0] + position[run, i, 1] + position[run, i, 2] + yaw[run, i]
            members[run, i] = said[run, i] and np.isfinite(total)
            movers[run, i] = members[run, i] and before[run, i]


@kernel
def fill_headings(swarms: Swarms, yaw: Floats) -> None:
    """Fill `heading`; zeros for absent robots."""
    heading, members, count = swarms.heading, swarms.members[ALL], list_runs(swarms, ALL)
    for first in range(0, count, LANES):
        runs = four_of(swarms.runs, first, count)
        for i in range(members.shape[1]):
            sine, cosine = sine_cosine(numbers(yaw, runs, i))
            inside = flags(members, runs, i) > 0.0
            put_coordinate(heading, runs, i, 0, chosen(inside, cosine, in_all(0.0)))
            put_coordinate(heading, runs, i, 1, chosen(inside, sine, in_all(0.0)))
            put_coordinate(heading, runs, i, 2, in_all(0.0))


@kernel
def fill_travel(swarms: Swarms) -> None:
    """Fill `travel`; zeros for robots without a previous pose."""
    position, before = swarms.position, swarms.memory.position
    travel, movers = swarms.travel, swarms.movers[ALL]
    for run in range(movers.shape[0]):
        for i in range(movers.shape[1]):
            x = position[run, i, 0] - before[run, i, 0]
            y = position[run, i, 1] - before[run, i, 1]
            z = position[run, i, 2] - before[run, i, 2]
            way = np.sqrt(x * x + y * y + z * z)
            if movers[run, i] and way > 0.0:
                travel[run, i, 0], travel[run, i, 1], travel[run, i, 2] = x / way, y / way, z / way
            else:
                travel[run, i, 0], travel[run, i, 1], travel[run, i, 2] = 0.0, 0.0, 0.0


@kernel
def remember(swarms: Swarms) -> None:
    """Write positions, presence and centres into the memory, for the next tick."""
    position, before = swarms.position, swarms.memory.position
    members, present = swarms.members[ALL], swarms.memory.present
    for run in range(members.shape[0]):
        for kind in range(2):
            for axis in range(3):
                swarms.memory.centre[kind, run, axis] = swarms.centre[ALL, kind, run, axis]
        for i in range(members.shape[1]):
            present[run, i] = members[run, i]
            for axis in range(3):
                before[run, i, axis] = position[run, i, axis]
