"""A vehicle that rolls and pitches as all others see it: its place, heading, and velocity along level axes.

The row of `world.state.state` holds what others, walls and statistics look at. Its axes are those of the body turned
level, so that x_dot = u cos(yaw) - v sin(yaw) and so on hold there as for everybody.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine, wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.six_degrees.attitude import to_body, to_world
from cocorosim_ros.world.six_degrees.state import ATTITUDE, ROLL_RATE, STATE_SIZE, SURGE
from cocorosim_ros.world.state import state as level

LEAST_LEVEL = 1e-12  # square of the bow's horizontal part below which it has no heading


@kernel
def write_level(row: Floats, seen: Floats) -> None:
    """Write place, heading and level velocities of the state `row` (STATE_SIZE,) into `seen` (level.STATE_SIZE,).

    The heading is not wrapped; while the bow points straight up or down it is the one before.
    """
    bow, ahead, velocity, turn, spin = stack_array(3), stack_array(3), stack_array(3), stack_array(3), stack_array(3)
    ahead[0] = 1.0
    to_world(row[ATTITUDE:SURGE], ahead, bow)
    to_world(row[ATTITUDE:SURGE], row[SURGE:ROLL_RATE], velocity)
    to_world(row[ATTITUDE:SURGE], row[ROLL_RATE:STATE_SIZE], turn)
    for axis in range(3):
        seen[level.X + axis] = row[axis]
    square = bow[0] * bow[0] + bow[1] * bow[1]
    seen[level.YAW_RATE] = 0.0
    if square > LEAST_LEVEL:
        spin[0], spin[1] = turn[1] * bow[2] - turn[2] * bow[1], turn[2] * bow[0] - turn[0] * bow[2]
        seen[level.YAW_RATE] = (bow[0] * spin[1] - bow[1] * spin[0]) / square
        seen[level.YAW] += wrap_angle(math.atan2(bow[1], bow[0]) - seen[level.YAW])
    sine, cosine = sine_cosine(seen[level.YAW])
    seen[level.SURGE] = velocity[0] * cosine + velocity[1] * sine
    seen[level.SWAY] = velocity[1] * cosine - velocity[0] * sine
    seen[level.HEAVE] = velocity[2]


@kernel
def take_level(seen: Floats, row: Floats) -> None:
    """Take place and velocity of `row` (STATE_SIZE,) from `seen`, where a wall has changed them."""
    velocity = stack_array(3)
    sine, cosine = sine_cosine(seen[level.YAW])
    velocity[0] = seen[level.SURGE] * cosine - seen[level.SWAY] * sine
    velocity[1] = seen[level.SURGE] * sine + seen[level.SWAY] * cosine
    velocity[2] = seen[level.HEAVE]
    for axis in range(3):
        row[axis] = seen[level.X + axis]
    to_body(row[ATTITUDE:SURGE], velocity, row[SURGE:ROLL_RATE])
