"""The robot's own operating system: heading, speed, depth, dive speed and obstacle avoidance.

The numbers are those of the authors' released model, in its units: an actuator's full command is 127, and
command / 127.5 is the fraction of the actuator's maximum that it delivers.
Source: Read et al. 2013, section 2.1; cocorosim-facts 1.4.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.angles import wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.request import (
    DIVE,
    DIVE_MODE,
    DIVE_TO_DEPTH,
    HEADING,
    SPEED,
    TURN_GAIN,
)
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE

SYSTEM_NUMBERS = (
    "wall_threshold",
    "floor_threshold",
    "surface_depth",
    "depth_margin",
    "avoidance_thrust",
    "avoidance_gain",
    "heading_gain",
    "yaw_rate_gain",
    "dive_speed_gain",
    "dive_acceleration_gain",
    "depth_gain",
    "dive_speed_limit",
    "full_command",
    "command_scale",
    "water_density",
    "gravity",
    "avoidance_lag",
)
WALL_THRESHOLD, FLOOR_THRESHOLD, SURFACE_DEPTH, DEPTH_MARGIN = 0, 1, 2, 3
AVOIDANCE_THRUST, AVOIDANCE_GAIN, HEADING_GAIN, YAW_RATE_GAIN = 4, 5, 6, 7
DIVE_SPEED_GAIN, DIVE_ACCELERATION_GAIN, DEPTH_GAIN, DIVE_SPEED_LIMIT = 8, 9, 10, 11
FULL_COMMAND, COMMAND_SCALE, WATER_DENSITY, GRAVITY, AVOIDANCE_LAG = 12, 13, 14, 15, 16

NO_DIRECTION = 1e-6  # m; a sum of infringements shorter than this points where rounding wants
AWAY_FORWARD, AWAY_LEFT, TOO_NEAR, WALLS_SIZE = 0, 1, 2, 3  # sum of infringements [m; body], whether there is any
VERTICAL = 0.5  # a cone whose axis rises or falls by more than 30 degrees looks at surface or floor


@kernel
def depth_of(observation: Observation, system: Floats) -> float:
    """Depth [m, down positive] by the pressure sensor."""
    depth: float = (observation.pressure - SURFACE_PRESSURE) / (system[WATER_DENSITY] * system[GRAVITY])
    return depth


@kernel
def avoid_walls(
    observation: Observation, sensor_axis: Floats, system: Floats, last_walls: Floats, request: Floats
) -> bool:
    """If a wall is too near, ask for the heading away from it and return True.

    Where the sensors contradict each other (all the same: at a wall), the heading asked for stays. With an avoidance
    lag the walls are those of the last cycle, `last_walls` (WALLS_SIZE,), relative to the present heading; it keeps
    the present ones for the next.
    """
    forward, left, near = 0.0, 0.0, False
    for sensor in range(sensor_axis.shape[0]):
        infringement = system[WALL_THRESHOLD] - observation.obstacle_range[sensor]
        if abs(sensor_axis[sensor, 2]) > VERTICAL or not infringement > 0.0:
            continue
        near = True
        forward -= infringement * sensor_axis[sensor, 0]
        left -= infringement * sensor_axis[sensor, 1]
    if system[AVOIDANCE_LAG] != 0.0:
        last_forward, last_left, last_near = last_walls[AWAY_FORWARD], last_walls[AWAY_LEFT], last_walls[TOO_NEAR]
        last_walls[AWAY_FORWARD], last_walls[AWAY_LEFT], last_walls[TOO_NEAR] = forward, left, 1.0 if near else 0.0
        forward, left, near = last_forward, last_left, last_near != 0.0
    if near:
        if math.hypot(forward, left) > NO_DIRECTION:
            request[HEADING] = wrap_angle(observation.compass + math.atan2(left, forward))
        request[SPEED] = system[AVOIDANCE_THRUST]
        request[TURN_GAIN] = system[AVOIDANCE_GAIN]
    return near


@kernel
def avoid_floor_and_surface(observation: Observation, sensor_axis: Floats, system: Floats, request: Floats) -> bool:
    """If floor or surface is too near, ask for a depth beyond the threshold and return True."""
    depth = depth_of(observation, system)
    if math.isnan(depth):
        return False
    for sensor in range(sensor_axis.shape[0]):
        height = observation.obstacle_range[sensor]
        if sensor_axis[sensor, 2] < -VERTICAL and height < system[FLOOR_THRESHOLD]:
            request[DIVE_MODE] = DIVE_TO_DEPTH
            request[DIVE] = depth + height - system[FLOOR_THRESHOLD] - system[DEPTH_MARGIN]
            return True
    if depth < system[SURFACE_DEPTH]:
        request[DIVE_MODE] = DIVE_TO_DEPTH
        request[DIVE] = system[SURFACE_DEPTH] + system[DEPTH_MARGIN]
        return True
    return False


@kernel
def steer(observation: Observation, system: Floats, request: Floats, actuator: Integers, command: Floats) -> None:
    """Drive the two thrusters so that the robot swims at the speed and turns to the heading of `request`.

    A PD controller sets the difference of the thrusters around the common speed; what one thruster cannot
    give is taken from the other. `actuator` holds the columns of left, right, buoyancy in `command`.
    """
    if math.isnan(observation.compass) or actuator[0] < 0 or actuator[1] < 0:
        return
    full = system[FULL_COMMAND]
    error = wrap_angle(request[HEADING] - observation.compass)
    gain = request[TURN_GAIN]
    turn = system[HEADING_GAIN] * gain * error
    turn -= system[YAW_RATE_GAIN] * math.sqrt(gain) * observation.angular_rate[2]
    common = full * min(max(request[SPEED], -1.0), 1.0)
    left, right = common - 0.5 * turn, common + 0.5 * turn
    excess = max(abs(left), abs(right)) - full
    if excess > 0.0:
        shift = -excess if max(left, right) > full else excess
        left, right = left + shift, right + shift
    command[actuator[0]] = min(max(left, -full), full) / system[COMMAND_SCALE]
    command[actuator[1]] = min(max(right, -full), full) / system[COMMAND_SCALE]


@kernel
def dive(
    observation: Observation,
    climb: float,
    system: Floats,
    request: Floats,
    actuator: Integers,
    command: Floats,
) -> None:
    """Drive the buoyancy pump to the depth or dive speed of `request`; `climb` is the speed upwards [m/s]."""
    if math.isnan(observation.pressure) or actuator[2] < 0:
        return
    wanted = request[DIVE]
    if request[DIVE_MODE] == DIVE_TO_DEPTH:
        wanted = system[DEPTH_GAIN] * (depth_of(observation, system) - request[DIVE])
        wanted = min(max(wanted, -system[DIVE_SPEED_LIMIT]), system[DIVE_SPEED_LIMIT])
    acceleration = observation.specific_force[2] - system[GRAVITY]
    if not math.isfinite(acceleration):
        acceleration = 0.0
    full = system[FULL_COMMAND]
    pump = system[DIVE_SPEED_GAIN] * (wanted - climb) + system[DIVE_ACCELERATION_GAIN] * acceleration
    command[actuator[2]] = min(max(pump, -full), full) / system[COMMAND_SCALE]
