"""Thrust lost in the jet of another thruster of the same vehicle: T (1 - loss c sqrt(T_j / T)) where T_j blows into T.

c is what is left of the jet at the place of the thruster (terms.jet) times the cosine of the angle between both pushes:
1 right behind the other propeller and in line, 0 beside the jet, and wherever both push against each other. With loss
= 1 two thrusters in line that push alike lose what ABS reckons with. A thruster in a jet meets water at its speed,
which goes as the root of the other's thrust T_j, and loses in proportion to that speed times its own rate of turn,
which goes as the root of T (Fossen's bilinear thrust): hence sqrt(T_j T). Jets turn with azimuths and with the sign of
the thrust; those of several thrusters add up.
It is looked for where a platform gives the `diameter` of thrusters, and their places and directions let a jet meet
another one. `neighbour_wake` is the push of another robot's jet on the hull, and leaves the thrust as it is.
Assumes: a straight jet in water at rest that is there at once and blows past the hull; nothing is lost where jets meet
from ahead or from the side.
Source: American Bureau of Shipping, Guide for Dynamic Positioning Systems (2013), section 8, after Lehn (1980);
bilinear thrust: Fossen (2021), section 9.2.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.jet import BY, BY_TURNED, DIAMETER, ON, ON_TURNED, left_of_jet
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Search, Strength


@kernel
def _push(moment: Moment, thruster: int, azimuth: int, push: Floats) -> float:
    """Write the wrench (4,) [N, N, N, N m; body] of a thruster that an azimuth may turn; return its force [N]."""
    squared = 0.0
    for axis in range(4):
        push[axis] = moment.actuator_wrench[thruster, axis] * moment.force[thruster]
        if azimuth >= 0:
            push[axis] += moment.actuator_wrench[azimuth, axis] * moment.force[azimuth]
        squared += push[axis] ** 2 if axis < 3 else 0.0
    return math.sqrt(squared)


@kernel
def _lost(pair: Floats, moment: Moment, push: Floats) -> float:
    """Share of its thrust that a thruster of a pair loses in the jet of the other, for a loss of 1.

    push (4,): where the wrench of that thruster is written [N, N, N, N m; body].
    """
    other = stack_array(4)
    blowing = _push(moment, int(pair[BY]), int(pair[BY_TURNED]), other)
    pushing = _push(moment, int(pair[ON]), int(pair[ON_TURNED]), push)
    common = push[0] * other[0] + push[1] * other[1] + push[2] * other[2]
    if common <= 0.0:
        return 0.0
    left = left_of_jet(pair, -other[0] / blowing, -other[1] / blowing, -other[2] / blowing)
    share: float = left * common / (blowing * pushing) * math.sqrt(blowing / pushing)
    return share


@kernel
def wash_loss(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Take away what each thruster loses in the jets of the others."""
    (loss,) = unpack(parameters, 1)
    push = stack_array(4)
    for number in range(moment.jets.shape[0]):
        if moment.jets[number, DIAMETER] <= 0.0:
            continue
        lost = loss * _lost(moment.jets[number], moment, push)
        for axis in range(4):
            total[axis] -= lost * push[axis]


WASH_LOSS = Effect(
    summary="thrust that is weaker in the jet of another thruster",
    equation="T (1 - loss c sqrt(T_j / T)) in the jet of T_j, c = cos(angle) 0.75^((x/D)^(2/3)) exp(-(a/b)^2)",
    wrench=wash_loss,
    parameters=(
        Number(
            "loss",
            "1",
            "fraction of its thrust lost right behind a thruster that pushes as much, about 1",
            sign="not negative",
            multiplies="N",
            gives="N",
            search=Strength(large=1.0, least=0.0),
            example=Example(1.0, "rule of ABS for two thrusters in line"),
            other_form=0.15,  # jets that widen otherwise, as those of neighbours
        ),
    ),
    search=Search(channel="surge", manoeuvre="ramps_through_zero"),
    needs=("thruster_in_a_jet",),
    check="Weigh the thrust of the rear thruster alone, and while the one before it pushes as well.",
)
