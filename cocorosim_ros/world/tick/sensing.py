"""All instruments of all robots at one tick."""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.motion.dynamics import relative_velocity, state_rate
from cocorosim_ros.world.motion.surroundings import look_around
from cocorosim_ros.world.sensors.blue_light import neighbour_ranges, obstacle_ranges
from cocorosim_ros.world.sensors.compass import compass_heading
from cocorosim_ros.world.sensors.inertial import angular_rate, specific_force
from cocorosim_ros.world.sensors.instruments import Instruments
from cocorosim_ros.world.sensors.pressure import absolute_pressure
from cocorosim_ros.world.state.readings import Readings
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.surroundings.neighbours import Neighbours
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.vehicles import Surroundings, Vehicles, body_of


class Afloat(NamedTuple):
    """All that a measurement depends on beside the state and the numbers of the instruments."""

    vehicles: Vehicles
    tank: Tank
    flow: Floats  # velocity of the water, see water.flow
    neighbours: Neighbours
    cones: Floats  # of the blue-light sensors, see sensors.cones


@allocating_kernel
def sense(
    state: Floats, time: float, afloat: Afloat, instruments: Instruments, readings: Readings, nearest: Integers
) -> None:
    """Measure `state` (runs, robots, columns) at `time` [s] with every instrument; the result is in `readings`.

    `nearest` (runs, robots, sensors) receives who is the nearest in each cone, -1 for nobody.
    """
    tank = afloat.tank
    surroundings = Surroundings(afloat.flow, tank.lower, tank.upper, look_around(state, afloat.vehicles))
    _sense_all(state, time, (afloat, surroundings), instruments, (readings, nearest))


@kernel
def _sense_all(
    state: Floats,
    time: float,
    place: tuple[Afloat, Surroundings],
    instruments: Instruments,
    result: tuple[Readings, Integers],
) -> None:
    afloat, surroundings = place
    readings, nearest = result
    relative, rate, neighbours = stack_array(4), stack_array(STATE_SIZE), afloat.neighbours
    runs, robots = state.shape[0], state.shape[1]
    for run in range(runs):
        for robot in range(robots):
            row = state[run, robot]
            density, gravity = instruments.water_density[robot], instruments.gravity[robot]
            readings.compass[run, robot] = compass_heading(row)
            readings.pressure[run, robot] = absolute_pressure(row, density, gravity)
            body = body_of(afloat.vehicles, surroundings, run, robot)
            state_rate(row, time, body, rate)
            angular_rate(row, readings.angular_rate[run, robot])
            specific_force(row, rate, gravity, readings.specific_force[run, robot])
            relative_velocity(row, time, body, relative)
            for axis in range(4):
                known = instruments.velocity_measured[robot]
                readings.velocity[run, robot, axis] = relative[axis] if known else math.nan
            nearby = neighbours.who[run, robot, : neighbours.near[run, robot]]
            seen = readings.neighbour_range[run, robot]
            neighbour_ranges(state[run], robot, nearby, afloat.cones, seen, nearest[run, robot])
            obstacle_ranges(row, robot, instruments, afloat.tank, readings.obstacle_range[run, robot])
