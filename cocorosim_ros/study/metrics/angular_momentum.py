"""Angular momentum: how far the robots circle around their centre.

m = |sum_i r_i x v_i| / N, with the vector r_i from the centre of the robots to robot i and the unit
direction v_i. r_i is a unit vector in Couzin et al. (0 <= m <= 1); the raw variant keeps its length, in
patches of 0.1 m as the NetLogo original measures. The norm is taken of the sum, in three dimensions. A
robot exactly at the centre, or one exactly at rest in the variants of travel, adds nothing to the sum and
counts in N; one that was absent at the previous tick does not count in the variants of travel. The paper
calls the same quantity angular momentum and angular velocity; the default follows Couzin et al.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.study.metrics.metric import COUZIN, READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import Swarms

_PATCH = 0.1


@kernel
def _fill_arms(swarms: Swarms, centre: Floats, done: Flags, arm: Floats) -> None:
    """The vector from the centre to each robot is in arm[..., :3], 1 over its length in arm[..., 3]; not where done."""
    position = swarms.position
    for run in range(arm.shape[0]):
        if done[run]:
            continue
        for i in range(arm.shape[1]):
            x = position[run, i, 0] - centre[run, 0]
            y = position[run, i, 1] - centre[run, 1]
            z = position[run, i, 2] - centre[run, 2]
            length = np.sqrt(x * x + y * y + z * z)
            arm[run, i, 0], arm[run, i, 1], arm[run, i, 2] = x, y, z
            arm[run, i, 3] = 1.0 / length if length > 0.0 else 0.0


@kernel
def _write_momenta(
    arm: Floats,
    direction: Floats,
    members: Flags,
    done: Flags,
    values: Floats,
    column: int,
) -> None:
    """The momentum with unit r is in values[:, column], that with raw r in the next column; not where done."""
    for run in range(members.shape[0]):
        if done[run]:
            continue
        unit_x, unit_y, unit_z, raw_x, raw_y, raw_z, count = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0
        for i in range(members.shape[1]):
            if members[run, i]:
                rx, ry, rz, per_length = arm[run, i, 0], arm[run, i, 1], arm[run, i, 2], arm[run, i, 3]
                vx, vy, vz = direction[run, i, 0], direction[run, i, 1], direction[run, i, 2]
                x, y, z = ry * vz - rz * vy, rz * vx - rx * vz, rx * vy - ry * vx
                raw_x, raw_y, raw_z = raw_x + x, raw_y + y, raw_z + z
                unit_x += x * per_length
                unit_y += y * per_length
                unit_z += z * per_length
                count += 1
        values[run, column] = np.sqrt(unit_x * unit_x + unit_y * unit_y + unit_z * unit_z) / count
        values[run, column + 1] = np.sqrt(raw_x * raw_x + raw_y * raw_y + raw_z * raw_z) / count / _PATCH


@allocating_kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    arm = np.empty((values.shape[0], swarms.shoal.shape[1], 4))
    done = np.zeros(values.shape[0], np.bool_)
    for population in range(2):
        members, movers = swarms.members[population], swarms.movers[population]
        for kind in range(2):
            _fill_arms(swarms, swarms.centre[population, kind], done, arm)
            _write_momenta(arm, swarms.heading, members, done, values, column)
            _write_momenta(arm, swarms.travel, movers, done, values, column + 2)
            column += 4
        done[:] = swarms.one_shoal
    for run in range(values.shape[0]):
        if done[run]:
            for before in range(column - 8, column):
                values[run, before] = values[run, before - 8]
    return column


def _metric(members: str, centre: str, direction: str, raw: str) -> Metric:
    who = "the largest shoal's robots" if members else "all robots"
    length = "the vector (in patches of 0.1 m)" if raw else "the unit vector"
    middle = "coordinate-wise median" if centre else "mean"
    way = "direction of travel" if direction else "heading"
    formula = (
        f"length of the sum of r x v over {who}, divided by their number; r is {length} from their {middle} "
        f"position, v the unit vector of {way}"
    )
    name = f"angular_momentum{raw}{direction}{centre}{members}"
    unit = "0.1 m" if raw else "1"
    paper = name == "angular_momentum"
    return Metric(name, unit, formula, f"{COUZIN}; {READ}", paper=paper, frame_free=not centre)


FAMILY = Family(
    metrics=tuple(
        _metric(members, centre, direction, raw)
        for members in ("", "_largest")
        for centre in ("", "_median_centre")
        for direction in ("", "_travel")
        for raw in ("", "_raw")
    ),
    measure=_measure,
)
