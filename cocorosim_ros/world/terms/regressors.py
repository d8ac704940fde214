"""REGRESSORS: what a law can be proportional to. The place in the table is the code that a law carries.

Velocities are those through the water; `thrust`, `yaw_command` and `pump` are what the actuators deliver.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.state.state import YAW, X, Y, Z
from cocorosim_ros.world.terms.moment import Moment, neighbour_distance


class Regressor(NamedTuple):
    """One of them."""

    name: str
    unit: str
    meaning: str


REGRESSORS: tuple[Regressor, ...] = (
    Regressor("1", "1", "a constant"),
    Regressor("x", "m", "the place along x of the world"),
    Regressor("y", "m", "the place along y of the world"),
    Regressor("z", "m", "the place upwards, negative below the surface"),
    Regressor("t", "s", "the time"),
    Regressor("u", "m/s", "the speed forwards"),
    Regressor("v", "m/s", "the speed to the left"),
    Regressor("w", "m/s", "the speed upwards"),
    Regressor("r", "rad/s", "the yaw rate"),
    Regressor("speed", "m/s", "the total speed"),
    Regressor("thrust", "N", "the forward force of the thrusters"),
    Regressor("yaw_command", "N m", "the yaw moment of the thrusters"),
    Regressor("pump", "N", "the force of the pump"),
    Regressor("pump_rate", "N/s", "the rate of change of the pump's force"),
    Regressor("sin_yaw", "1", "the sine of the heading"),
    Regressor("cos_yaw", "1", "the cosine of the heading"),
    Regressor("sin_t", "1", "the sine of a fixed rate times the time"),
    Regressor("cos_t", "1", "the cosine of a fixed rate times the time"),
    Regressor("neighbour_distance", "m", "the distance to the nearest neighbour"),
    Regressor("wall_distance", "m", "the distance to the nearest of walls, floor and surface"),
)
REGRESSOR_CODE = {regressor.name: code for code, regressor in enumerate(REGRESSORS)}


@kernel
def fill_regressors(row: Floats, relative: Floats, moment: Moment, swing: float, values: Floats) -> None:
    """Write the value of every entry of REGRESSORS into `values`, in their units; `swing` [rad] of sin_t, cos_t."""
    values[0] = 1.0
    values[1], values[2], values[3] = row[X], row[Y], row[Z]
    values[4] = moment.time
    for axis in range(4):
        values[5 + axis] = relative[axis]
    values[9] = math.sqrt(relative[0] ** 2 + relative[1] ** 2 + relative[2] ** 2)
    values[10], values[11] = moment.thrust[0], moment.thrust[3]
    values[12], values[13] = moment.pump, moment.pump_rate
    values[14], values[15] = sine_cosine(row[YAW])
    values[16], values[17] = sine_cosine(swing)
    values[18] = neighbour_distance(row, moment.neighbours, moment.own)
    values[19] = moment.clearance
