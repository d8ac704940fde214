"""The true state of every robot: one row of numbers per robot, columns named here.

Shape (runs, robots, row_size(actuators)). Position and yaw are in the world frame (REP 103 east-north-up,
origin at the water surface over the tank's centre), velocities in the robot's body frame (forward-left-up;
Fossen's nu for the four degrees of freedom of a vehicle that neither pitches nor rolls). Behind STATE_SIZE come,
one per actuator, the forces that they deliver at this moment [N], then the commands that hold (fractions), then what
they remember.
"""

from __future__ import annotations

X = 0  # m, world
Y = 1  # m, world
Z = 2  # m, world, negative below the surface
YAW = 3  # rad, counter-clockwise from +x, not wrapped
SURGE = 4  # u, m/s, body
SWAY = 5  # v, m/s, body
HEAVE = 6  # w, m/s, body
YAW_RATE = 7  # r, rad/s
STATE_SIZE = 8  # forces, commands and memories of the actuators follow

# What one actuator remembers, in the order of its columns.
LAGGED = 0  # N, behind the lag
PLAY = 1  # N, behind the backlash
FOLLOWED = 2  # N, the delivered force a while ago, smoothed
RATE = 3  # N/s, at which the delivered force changes
MEMORY_SIZE = 4


def row_size(actuators: int) -> int:
    """How many columns a robot with so many actuators has."""
    return STATE_SIZE + (2 + MEMORY_SIZE) * actuators
