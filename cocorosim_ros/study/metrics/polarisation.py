"""Polarisation: how far the robots point, or travel, the same way.

p = |sum_i v_i| / N with unit directions v_i; 1 aligned, 0 evenly spread. The paper leaves open whether
"pointed" means heading or travel, and whether all robots count or the shoal's: the default is the heading
of all robots. A robot exactly at rest has no direction of travel: it adds nothing to the sum and counts in
N (so do Jhawar et al. 2020); one that was absent at the previous tick does not count.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.metric import COUZIN, READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import Swarms


@kernel
def _write_polarisation(direction: Floats, members: Flags, values: Floats, column: int) -> None:
    for run in range(members.shape[0]):
        x, y, z, count = 0.0, 0.0, 0.0, 0
        for i in range(members.shape[1]):
            if members[run, i]:
                x += direction[run, i, 0]
                y += direction[run, i, 1]
                z += direction[run, i, 2]
                count += 1
        values[run, column] = np.sqrt(x * x + y * y + z * z) / count


@kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    for population in range(2):
        _write_polarisation(swarms.heading, swarms.members[population], values, column)
        _write_polarisation(swarms.travel, swarms.movers[population], values, column + 1)
        column += 2
    return column


def _metric(suffix: str, direction: str, members: str, paper: bool = False) -> Metric:
    formula = f"length of the sum of the unit vectors of {direction} of {members}, divided by their number"
    return Metric(f"polarisation{suffix}", "1", formula, f"{COUZIN}; {READ}", paper=paper)


FAMILY = Family(
    metrics=(
        _metric("", "heading", "all robots", paper=True),
        _metric("_travel", "direction of travel", "all robots"),
        _metric("_largest", "heading", "the largest shoal's robots"),
        _metric("_travel_largest", "direction of travel", "the largest shoal's robots"),
    ),
    measure=_measure,
)
