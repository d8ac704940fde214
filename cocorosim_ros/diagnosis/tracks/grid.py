"""Where the grid of a filter begins, and how fine it is."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.foundation.arrays import Floats

LONGEST_STEP = 0.1  # s
YAW_ERROR, PLACE_ERROR = 0.005, 0.001  # rad, m: what a step under full acceleration may miss by


def grid_step(acceleration: float, yaw_acceleration: float) -> float:
    """Step [s] of the filter for a vehicle with these greatest accelerations [m/s^2, rad/s^2], a multiple of 10 ms."""
    step = LONGEST_STEP
    if acceleration > 0.0:
        step = min(step, math.sqrt(8.0 * PLACE_ERROR / acceleration))
    if yaw_acceleration > 0.0:
        step = min(step, math.sqrt(8.0 * YAW_ERROR / yaw_acceleration))
    return max(0.01, math.floor(step * 100.0 + 1e-9) / 100.0)


def grid_begin(command_time: Floats, step: float, begin: float) -> float:
    """Where a grid of this step begins, at most a step before `begin` [s], so that commands change at grid points.

    Between grid points the filter knows only the mean of what acts.
    """
    if len(command_time) == 0:
        return begin
    turns = np.exp(2j * np.pi * (command_time - begin) / step)
    phase = float(np.angle(turns.mean()) / (2.0 * np.pi)) % 1.0
    return begin - (1.0 - phase) * step if phase > 0.0 else begin


def grid_until(begin: float, step: float, end: float) -> Grid:
    """The grid from `begin` to the last point at or before `end` [s], of two points at least."""
    return Grid(begin, step, max(2, math.floor((end - begin) / step + 1e-9) + 1))
