"""Mean force of every actuator between two grid points, from recorded commands."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.filter.records import Grid
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel
from cocorosim_ros.world.motion.actuation import actuate
from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.state.state import MEMORY_SIZE, RATE
from cocorosim_ros.world.vehicle_model.vehicles import Body


@allocating_kernel
def mean_forces(command_time: Floats, command: Floats, body: Body, grid: Grid) -> tuple[Floats, Floats]:
    """(points, A) force [N] by actuator, averaged from each grid point to the next, and its rate of change [N/s].

    command_time (m,) [s], ascending, command (m, A); before the first command everything is off.
    """
    begin, step, points = grid.begin, grid.step, grid.points
    actuators = command.shape[1]
    force, rate = np.zeros((points, actuators)), np.zeros((points, actuators))
    memory, mean, off = np.zeros(MEMORY_SIZE * actuators), np.zeros(actuators), np.zeros(actuators)
    now = -1
    while now + 1 < command_time.shape[0] and command_time[now + 1] <= begin:
        now += 1
    for point in range(points):
        left, end = begin + point * step, begin + (point + 1) * step
        while left < end:
            right = end
            if now + 1 < command_time.shape[0] and command_time[now + 1] < end:
                right = max(command_time[now + 1], left)
            if right > left:
                actuate(off if now < 0 else command[now], memory, body, Interval(left, right - left), mean)
                for actuator in range(actuators):
                    force[point, actuator] += mean[actuator] * (right - left) / step
            if right < end:
                now += 1
            left = right
        for actuator in range(actuators):
            rate[point, actuator] = memory[MEMORY_SIZE * actuator + RATE]
    return force, rate
