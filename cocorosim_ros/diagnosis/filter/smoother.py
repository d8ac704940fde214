"""The course of a recording given all of its readings: Rauch, Tung and Striebel, AIAA Journal 3 (1965) 1445."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.records import History
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel

WIDE = np.array([0, 1, 3, 4, 5, 7, 8, 9, 11, 12, 13, 15])  # x y yaw u v r, force x y, moment, gusts of these
HIGH = np.array([2, 6, 10, 14])  # z w, force z, its gust


class Block(NamedTuple):
    """One block of a history: states and covariances before and after the readings of each grid point."""

    mean_before: Floats  # (points, 16)
    mean_after: Floats
    before: Floats  # (points, size, size)
    after: Floats
    step: Floats  # (points, size, size) transition from the grid point before


@allocating_kernel
def _back(places: Floats, block: Block, out: Floats) -> None:
    """Write mean and standard deviation of the block whose states are in columns `places` into out (2, points, 16)."""
    before, after = block.mean_before, block.mean_after
    points, size = after.shape[0], places.shape[0]
    covariance = block.after[points - 1].copy()
    for i in range(size):
        out[0, points - 1, places[i]] = after[points - 1, places[i]]
        out[1, points - 1, places[i]] = np.sqrt(max(covariance[i, i], 0.0))
    change = np.empty(size)
    for point in range(points - 2, -1, -1):
        ahead = block.before[point + 1].copy()
        for i in range(size):
            ahead[i, i] += 1e-12 * ahead[i, i] + 1e-300
        gain = np.linalg.solve(ahead, block.step[point + 1] @ block.after[point]).T
        for i in range(size):
            change[i] = out[0, point + 1, places[i]] - before[point + 1, places[i]]
        moved = gain @ change
        covariance = block.after[point] + gain @ (covariance - block.before[point + 1]) @ gain.T
        for i in range(size):
            out[0, point, places[i]] = after[point, places[i]] + moved[i]
            out[1, point, places[i]] = np.sqrt(max(covariance[i, i], 0.0))


@allocating_kernel
def smooth(history: History) -> tuple[Floats, Floats]:
    """(points, 16) mean and (points, 16) standard deviation of the state at each grid point."""
    out = np.zeros((2, history.after.shape[0], 16))
    before, after = history.before, history.after
    _back(WIDE, Block(before, after, history.wide_before, history.wide_after, history.wide_step), out)
    _back(HIGH, Block(before, after, history.high_before, history.high_after, history.high_step), out)
    return out[0], out[1]
