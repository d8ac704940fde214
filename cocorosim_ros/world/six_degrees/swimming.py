"""One tick of motion, and what inertial sensors feel, for all vehicles in six degrees of freedom of all runs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.motion.contact import keep_in_tank
from cocorosim_ros.world.motion.motion import Stepping
from cocorosim_ros.world.motion.obstacle_contact import keep_out_of_obstacles
from cocorosim_ros.world.six_degrees.attitude import to_body
from cocorosim_ros.world.six_degrees.bodies import Bodies, body_of
from cocorosim_ros.world.six_degrees.dynamics import add_cross, relative_velocity, state_rate
from cocorosim_ros.world.six_degrees.levelled import take_level, write_level
from cocorosim_ros.world.six_degrees.state import ATTITUDE, ROLL_RATE, STATE_SIZE, SURGE
from cocorosim_ros.world.six_degrees.stepping import set_effort, take_step
from cocorosim_ros.world.surroundings.tank import Tank


class School(NamedTuple):
    """The vehicles in six degrees of freedom of a world."""

    bodies: Bodies
    number: Integers  # (vehicles,) their places among all robots


class Around(NamedTuple):
    """Where they swim, and room for what their actuators do at the moment."""

    flow: Floats  # velocity of the water, see water.flow; empty in still water
    tank: Tank
    effort: Floats  # (actuators,) written


class Felt(NamedTuple):
    """Readings of all robots, of which those of the vehicles are written, where there are any."""

    angular_rate: Floats  # (runs, robots, 3) [rad/s; body]
    specific_force: Floats  # (runs, robots, 3) [m/s^2; body]
    velocity: Floats  # (runs, robots, 4) u v w r through the water [m/s, rad/s; body]; NaN where not measured
    ground_velocity: Floats  # (runs, robots, 3) u v w over ground [m/s; body]; NaN where not measured


class Moment(NamedTuple):
    """When a tick begins and how it is cut into steps."""

    begin: float  # s
    stepping: Stepping


@allocating_kernel
def swim(state: Floats, command: Floats, school: School, around: Around, moment: Moment, seen: Floats) -> None:
    """Advance `state` (runs, vehicles, STATE_SIZE) in place by one tick.

    command: (runs, robots, actuators) fractions of all robots, which hold for the tick. seen: (runs, robots, columns)
    of all robots, of which the rows of the vehicles are written, see `levelled`.
    """
    _swim_all(state, command, school, around, moment, seen)


@allocating_kernel
def feel(state: Floats, command: Floats, school: School, around: Around, time: float, felt: Felt) -> None:
    """Write what gyroscope, accelerometer and speed logs of every vehicle show at `time` [s] under commands that hold.

    The instruments are at the origin of the body axes. Specific force: acceleration less gravity, v_dot + omega x v +
    g k, with k the world's vertical in body axes (Fossen 2011, eq. 11.6 without errors).
    """
    _feel_all(state, command, school, around, time, felt)


@kernel
def _swim_all(state: Floats, command: Floats, school: School, around: Around, moment: Moment, seen: Floats) -> None:
    stepping = moment.stepping
    for run in range(state.shape[0]):
        for vehicle in range(state.shape[1]):
            number = school.number[vehicle]
            body, row, level = body_of(school.bodies, vehicle, around.flow), state[run, vehicle], seen[run, number]
            set_effort(command[run, number], body, around.effort)
            for index in range(stepping.steps):
                take_step(row, moment.begin + index * stepping.step, stepping.step, around.effort, body)
                write_level(row, level)
                keep_out_of_obstacles(level, around.tank, stepping.contact)
                keep_in_tank(level, around.tank, stepping.contact)
                if level[0] != row[0] or level[1] != row[1] or level[2] != row[2]:
                    take_level(level, row)


@kernel
def _feel_all(state: Floats, command: Floats, school: School, around: Around, time: float, felt: Felt) -> None:
    for run in range(state.shape[0]):
        for vehicle in range(state.shape[1]):
            number, row = school.number[vehicle], state[run, vehicle]
            body, rate = body_of(school.bodies, vehicle, around.flow), stack_array(STATE_SIZE)
            set_effort(command[run, number], body, around.effort)
            state_rate(row, time, around.effort, body, rate)
            force, velocity = felt.specific_force[run, number], felt.velocity[run, number]
            gravity, up = stack_array(3), stack_array(3)
            gravity[2] = school.bodies.gravity[vehicle]
            to_body(row[ATTITUDE:SURGE], gravity, up)
            for axis in range(3):
                felt.angular_rate[run, number, axis] = row[ROLL_RATE + axis]
                force[axis] = rate[SURGE + axis] + up[axis]
            add_cross(row[ROLL_RATE:STATE_SIZE], row[SURGE:ROLL_RATE], force)
            if not np.isnan(velocity[0]):
                drift, relative = stack_array(3), stack_array(6)
                relative_velocity(row, time, body.flow, drift, relative)
                for axis in range(3):
                    velocity[axis] = relative[axis]
                velocity[3] = row[STATE_SIZE - 1]
            if not np.isnan(felt.ground_velocity[run, number, 0]):
                for axis in range(3):
                    felt.ground_velocity[run, number, axis] = row[SURGE + axis]
