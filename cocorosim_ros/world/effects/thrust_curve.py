"""Thrust by another power of the command than the platform says: sign(s) |s|^exponent.

s is the share of the limit by the platform's own curve. Exponent 2 makes a square law of a straight line, as of a
propeller whose rate of turn is commanded while the file gives its thrust; below 1 thrust comes early, as behind a
driver that evens out a square law which the motor does not have.
Source of the square: thrust K_T rho n^2 D^4 of a propeller at rest, Fossen (2021), section 9.2.
"""

from __future__ import annotations

import math
from typing import Any

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.curve import is_thruster, of_power
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def thrust_curve(share: Floats, fitting: Any, time: float, parameters: Floats) -> None:
    """Raise what all thrusters give to a power."""
    (exponent,) = unpack(parameters, 1)
    for actuator in range(share.shape[0]):
        if is_thruster(fitting.is_pump, fitting.curve, actuator):
            share[actuator] = of_power(share[actuator], exponent)


THRUST_CURVE = Effect(
    summary="another curve of the thrust over the command",
    equation="T = sign(T_0) T_max |T_0 / T_max|^exponent",
    thrust=thrust_curve,
    parameters=(
        Number(
            "exponent",
            "1",
            "power of what the platform's own curve gives; 2 makes a square law of a straight line",
            neutral=1.0,
            sign="positive",
            gives="1",
            search=Strength(large=0.5, least=-1.0, most=4.0),
            between=(0.0, math.inf),
            example=Example(1.7, "staircase of thrust on a scale"),
        ),
    ),
    search=Search(channel="surge", manoeuvre="thrust_staircase"),
    check="Weigh the thrust at a quarter, at half and at all of the command, and give the thruster that curve.",
)
