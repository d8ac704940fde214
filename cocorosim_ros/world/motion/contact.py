"""What happens at walls, floor and surface: the centre of a robot cannot leave the water.

Robots are points, as in the paper; they do not collide with each other (contacts of robots have no physics
there either).
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import HEAVE, SURGE, SWAY, YAW, X
from cocorosim_ros.world.surroundings.tank import Tank

STOP_POSITION = 0  # the paper's: the coordinate stops, the velocity is kept
INELASTIC = 1  # the velocity into the wall is lost
CONTACT_CODE = {"stop_position": STOP_POSITION, "inelastic": INELASTIC}


@kernel
def is_in_tank(row: Floats, tank: Tank) -> bool:
    """Whether one robot's centre is within walls, floor and surface."""
    inside = True
    for axis in range(3):
        inside = inside and tank.lower[axis] <= row[X + axis] <= tank.upper[axis]
    return inside


@kernel
def keep_in_tank(row: Floats, tank: Tank, contact: int) -> None:
    """Put one robot's state back into the tank if a step took it out."""
    if is_in_tank(row, tank):
        return
    sine, cosine = sine_cosine(row[YAW])
    velocity_x = row[SURGE] * cosine - row[SWAY] * sine
    velocity_y = row[SURGE] * sine + row[SWAY] * cosine
    touched = False
    for axis in range(3):
        inside = min(max(row[X + axis], tank.lower[axis]), tank.upper[axis])
        if inside == row[X + axis]:
            continue
        row[X + axis] = inside
        touched = True
        if axis == 0:
            velocity_x = 0.0
        elif axis == 1:
            velocity_y = 0.0
        elif contact == INELASTIC:
            row[HEAVE] = 0.0
    if touched and contact == INELASTIC:
        row[SURGE] = velocity_x * cosine + velocity_y * sine
        row[SWAY] = velocity_y * cosine - velocity_x * sine
