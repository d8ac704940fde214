"""Lost: how often a robot lost its neighbours since the start of the run.

An event is one robot's change from at least one neighbour within 0.5 m to none; it is armed again when the
robot meets another. A robot that starts alone is not lost, one that is absent keeps its state until it is
seen again, and absent robots are nobody's neighbours. The variants ask instead whether a neighbour within
0.5 m lies in a cone of Lily's blue-light sensors: five axes (60 degrees to the left and right of the bow,
back, up, down) with 120 degrees of opening. They do not see the whole sphere.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, chosen, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.sorting import ordered
from cocorosim_ros.study.metrics.four_runs import FourRuns, Vectors, four_of, in_all, list_runs, numbers, vectors
from cocorosim_ros.study.metrics.memory import CONTACT_KINDS
from cocorosim_ros.study.metrics.metric import READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import ALL, CONTACT_RANGE, Swarms

_RANGE_SQUARED = CONTACT_RANGE * CONTACT_RANGE
_SIDE_X, _SIDE_Y = 0.5, 0.8660254037844386
# A neighbour straight ahead lies exactly on the edge of both front cones: rounding must not hide it.
_COS_HALF_OPENING = 0.5 - 1e-9

# Columns of the working space of each robot: place and heading, then contact of each kind.
_X, _Y, _Z, _AHEAD_X, _AHEAD_Y, _NEAR, _SEEN, _SEEN_BUT_BACK = 0, 1, 2, 3, 4, 5, 6, 7


@kernel
def _larger(one: Any, other: Any) -> Any:
    return ordered(one, other)[1]


class _Contacts(NamedTuple):
    """Which contacts a robot of four runs has: 0.0 or 1.0 of each kind."""

    near: Any
    seen: Any
    seen_but_back: Any


@kernel
def _met(before: _Contacts, near: Any, ahead_x: Any, ahead_y: Any, offset: Vectors) -> _Contacts:
    """The contacts of a robot when one more robot at this offset from it counts where it is `near`."""
    forward = ahead_x * offset.x + ahead_y * offset.y
    left = ahead_x * offset.y - ahead_y * offset.x
    but_back = _larger(abs(offset.z), _SIDE_X * forward + _SIDE_Y * abs(left))
    distance = math.sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z)
    # Nothing compares with NaN: who is not near, or absent, is not seen.
    edge, yes = chosen(near, _COS_HALF_OPENING * distance, in_all(np.nan)), in_all(1.0)
    return _Contacts(
        chosen(near, yes, before.near),
        chosen(_larger(but_back, -forward) >= edge, yes, before.seen),
        chosen(but_back >= edge, yes, before.seen_but_back),
    )


@kernel
def _fill_contacts(swarms: Swarms, runs: FourRuns, robot: Any) -> None:
    """Fill the contacts in robot (n, 8)."""
    pair, no = 0, in_all(0.0)
    for i in range(robot.shape[0]):
        robot[i, _X], robot[i, _Y], robot[i, _Z] = vectors(swarms.position, runs, i)
        robot[i, _AHEAD_X], robot[i, _AHEAD_Y], _ = vectors(swarms.heading, runs, i)
        _put_contacts(robot, i, _Contacts(no, no, no))
    for i in range(robot.shape[0]):
        found = _contacts_of(robot, i)
        for j in range(i + 1, robot.shape[0]):
            near = numbers(swarms.squared, runs, pair) <= _RANGE_SQUARED
            x, y, z = robot[j, _X] - robot[i, _X], robot[j, _Y] - robot[i, _Y], robot[j, _Z] - robot[i, _Z]
            found = _met(found, near, robot[i, _AHEAD_X], robot[i, _AHEAD_Y], Vectors(x, y, z))
            other = _met(_contacts_of(robot, j), near, robot[j, _AHEAD_X], robot[j, _AHEAD_Y], Vectors(-x, -y, -z))
            _put_contacts(robot, j, other)
            pair += 1
        _put_contacts(robot, i, found)


@kernel
def _contacts_of(robot: Any, one: int) -> _Contacts:
    return _Contacts(robot[one, _NEAR], robot[one, _SEEN], robot[one, _SEEN_BUT_BACK])


@kernel
def _put_contacts(robot: Any, one: int, contacts: _Contacts) -> None:
    robot[one, _NEAR], robot[one, _SEEN], robot[one, _SEEN_BUT_BACK] = contacts


@kernel
def _count(swarms: Swarms, run: int, now: Floats, lane: int) -> None:
    """Count the contacts of a run that are lost; now: (n, 8, 4), the contacts in the last columns of each robot."""
    members, contact, lost = swarms.members[ALL], swarms.memory.contact, swarms.memory.lost
    for kind in range(CONTACT_KINDS):
        events = 0
        for i in range(members.shape[1]):
            # No branch: a processor would guess many of them wrong.
            inside, before, here = members[run, i], contact[run, i, kind], now[i, _NEAR + kind, lane] > 0.0
            events += inside & before & (not here)
            contact[run, i, kind] = (inside & here) | (before & (not inside))
        lost[run, kind] += events


@kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    count = list_runs(swarms, ALL)
    for first in range(0, count, LANES):
        _fill_contacts(swarms, four_of(swarms.runs, first, count), in_fours(swarms.rows_of_robots))
        for lane in range(min(LANES, count - first)):
            _count(swarms, first + lane, swarms.rows_of_robots, lane)
    for run in range(values.shape[0]):
        for kind in range(CONTACT_KINDS):
            values[run, column + kind] = swarms.memory.lost[run, kind]
    return column + CONTACT_KINDS


def _metric(suffix: str, contact: str, paper: bool = False) -> Metric:
    formula = f"number of changes, since the start and over all robots, from {contact} to none"
    return Metric(f"lost{suffix}", "1", formula, READ, summary="last", paper=paper)


FAMILY = Family(
    metrics=(
        _metric("", "at least one robot within 0.5 m", paper=True),
        _metric("_blss", "at least one robot within 0.5 m and in one of Lily's five cones"),
        _metric("_blss_no_back", "at least one robot within 0.5 m and in one of Lily's cones but the back one"),
    ),
    measure=_measure,
)
