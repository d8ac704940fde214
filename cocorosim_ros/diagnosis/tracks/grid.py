"""Begin and step of the grid of a filter."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import GRID
from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.foundation.arrays import Floats


def grid_step(acceleration: float, yaw_acceleration: float, coasting: float = 0.0) -> float:
    """Step [s] of the filter for a vehicle with these greatest accelerations [m/s^2, rad/s^2], a multiple of 10 ms.

    A step h under an acceleration a that sets in or ends within it errs by up to a h^2 / 8. coasting: the shortest time
    [s] in which the vehicle loses half of a full speed; slow vehicles have longer steps.
    """
    step = min(max(GRID.longest_step, coasting / GRID.steps_of_coasting), GRID.slowest_step)
    if acceleration > 0.0:
        step = min(step, math.sqrt(8.0 * GRID.place_error / acceleration))
    if yaw_acceleration > 0.0:
        step = min(step, math.sqrt(8.0 * GRID.yaw_error / yaw_acceleration))
    return max(GRID.shortest_step, math.floor(step * 100.0 + 1e-9) / 100.0)


def grid_begin(command_time: Floats, step: float, begin: float) -> float:
    """Time [s] at which a grid begins so that commands change at grid points; at most a step [s] before `begin` [s].

    command_time (n,): moments of the commands [s]; their mean phase within a step is taken. Between grid points the
    filter knows only the mean of the forces, so that a change there would be smeared.
    """
    if len(command_time) == 0:
        return begin
    turns = np.exp(2j * np.pi * (command_time - begin) / step)
    phase = float(np.angle(turns.mean()) / (2.0 * np.pi)) % 1.0
    return begin - (1.0 - phase) * step if phase > 0.0 else begin


def grid_until(begin: float, step: float, end: float) -> Grid:
    """Make the grid from `begin` to the last point at or before `end` [s], of two points at least."""
    return Grid(begin, step, max(2, math.floor((end - begin) / step + 1e-9) + 1))
