"""Lost: how often a robot lost its neighbours since the start of the run.

An event is one robot's change from at least one neighbour within 0.5 m to none; it is armed again when the
robot meets another. A robot that starts alone is not lost, one that is absent keeps its state until it is
seen again, and absent robots are nobody's neighbours. The variants ask instead whether a neighbour within
0.5 m lies in a cone of Lily's blue-light sensors: five axes (60 degrees to the left and right of the bow,
back, up, down) with 120 degrees of opening. They do not see the whole sphere.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.study.metrics.memory import CONTACT_KINDS
from cocorosim_ros.study.metrics.metric import READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import ALL, CONTACT_RANGE, Swarms

_RANGE_SQUARED = CONTACT_RANGE * CONTACT_RANGE
_SIDE_X, _SIDE_Y = 0.5, 0.8660254037844386
# A neighbour straight ahead lies exactly on the edge of both front cones: rounding must not hide it.
_COS_HALF_OPENING = 0.5 - 1e-9


@kernel
def _cones(position: Floats, heading: Floats, run: int, i: int, j: int) -> tuple[bool, bool]:
    """Whether robot i sees robot j: by any cone, and by any cone but the back one."""
    x = position[run, j, 0] - position[run, i, 0]
    y = position[run, j, 1] - position[run, i, 1]
    up = position[run, j, 2] - position[run, i, 2]
    forward = heading[run, i, 0] * x + heading[run, i, 1] * y
    left = heading[run, i, 0] * y - heading[run, i, 1] * x
    edge = _COS_HALF_OPENING * np.sqrt(x * x + y * y + up * up)
    but_back = abs(up) >= edge or _SIDE_X * forward + _SIDE_Y * abs(left) >= edge
    return but_back or -forward >= edge, but_back


@kernel
def _fill_contacts(swarms: Swarms, now: Flags) -> None:
    """Fill now (runs, n, kinds): the robot has contact."""
    position, heading, squared = swarms.position, swarms.heading, swarms.squared
    now[:] = False
    for run in range(now.shape[0]):
        pair = 0
        for i in range(now.shape[1]):
            for j in range(i + 1, now.shape[1]):
                if squared[run, pair] <= _RANGE_SQUARED:
                    for one, other in ((i, j), (j, i)):
                        now[run, one, 0] = True
                        if now[run, one, 2]:
                            continue  # who is seen by any cone but the back one is seen by any cone
                        seen, seen_but_back = _cones(position, heading, run, one, other)
                        now[run, one, 1] |= seen
                        now[run, one, 2] |= seen_but_back
                pair += 1


@allocating_kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    members, contact, lost = swarms.members[ALL], swarms.memory.contact, swarms.memory.lost
    now = np.empty_like(contact)
    _fill_contacts(swarms, now)
    for run in range(members.shape[0]):
        for kind in range(CONTACT_KINDS):
            for i in range(members.shape[1]):
                if members[run, i]:
                    lost[run, kind] += contact[run, i, kind] and not now[run, i, kind]
                    contact[run, i, kind] = now[run, i, kind]
            values[run, column + kind] = lost[run, kind]
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
