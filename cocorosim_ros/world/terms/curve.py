"""From the command of an actuator to what it delivers, as a share of its limit: rows of numbers, and their function.

A row has FORM, NUMBER and the points of a table. Of a thruster with a dead band d (NUMBER) and x = (|c| - d) / (1 - d),
0 within the dead band: linear: sign(c) x; square: sign(c) x^2. A table of n (NUMBER) points has the n commands and
behind them the n shares, straight in between. Of what is told an angle or a way, the share is the command.
Source of the square: thrust K_T rho n^2 D^4 of a propeller at rest, Fossen (2021), section 9.2.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel

FORM, NUMBER, POINTS = 0, 1, 2  # columns; the points of a table begin at the last of these
LINEAR, SQUARE, TABLE = 0.0, 1.0, 2.0
ANGLE, AZIMUTH = 3.0, 4.0  # told an angle or a way; NUMBER of an azimuth is the place of the thruster that it turns


@kernel
def thrust_share(curve: Floats, fraction: float) -> float:
    """The force at a command, as a share of the maximum in its direction; the same sign as the command, or 0."""
    if curve[FORM] >= ANGLE:
        return fraction
    if curve[FORM] == TABLE:
        tabled: float = _between(curve[POINTS:], int(curve[NUMBER]), fraction)
        return tabled
    dead = curve[NUMBER]
    beyond = max(abs(fraction) - dead, 0.0) / (1.0 - dead)
    if curve[FORM] == SQUARE:
        beyond *= beyond
    return math.copysign(beyond, fraction)


@kernel
def of_power(share: float, exponent: float) -> float:
    """A power of a share of the limit, with its sign: the same at rest and at full command, less in between above 1."""
    return math.copysign(abs(share) ** exponent, share)


@kernel
def _between(points: Floats, count: int, fraction: float) -> float:
    """The share between the two points of a table next to a command; at its ends that of the end."""
    after = 0
    while after < count and points[after] < fraction:
        after += 1
    if after in (0, count):
        end: float = points[count + min(after, count - 1)]
        return end
    way = (fraction - points[after - 1]) / (points[after] - points[after - 1])
    low, high = points[count + after - 1], points[count + after]
    between: float = low + way * (high - low)
    return between


@kernel
def is_thruster(is_pump: Flags, curve: Floats, actuator: int) -> bool:
    """Whether an actuator pushes by its command; `curve` (actuators, columns), without columns if all are plain."""
    thruster: bool = not is_pump[actuator] and (curve.shape[1] == 0 or curve[actuator, FORM] < ANGLE)
    return thruster


@kernel
def turn_thrusts(curve: Floats, force: Floats) -> None:
    """Part the force [N] of each turned thruster: along its own direction, and to its left in its azimuth's place.

    Before, that place holds the angle [rad]. Parts have means over time, which angles beyond half a turn have not.
    """
    for actuator in range(force.shape[0]):
        if curve[actuator, FORM] == AZIMUTH:
            thruster, (sine, cosine) = int(curve[actuator, NUMBER]), sine_cosine(force[actuator])
            force[actuator] = force[thruster] * sine
            force[thruster] *= cosine
