"""The jet of a neighbour's thrusters pushes: gain F 0.1 m / d on its axis, d behind the neighbour.

F is the horizontal force of all its thrusters; the jet blows against it. Across the jet the push falls as
exp(-(a / b)^2) with the half-width b = 0.05 m + 0.107 d. Nearer than 0.1 m it stays as it is there.
Assumes: the jet is there at once and straight, and does not pass through anybody.
Source: velocity 1/d and half-width 0.107 d of a round turbulent jet: Fischer et al., Mixing in Inland and Coastal
Waters (1979), chapter 9; 0.05 m is the half of a Lily that the jet meets.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import YAW, X, Y, Z
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.moment import NEIGHBOUR_FORCE, Moment
from cocorosim_ros.world.terms.search import Search, Strength

REFERENCE = 0.1  # m
JET_RADIUS = 0.05  # m
JET_SPREAD = 0.107


@kernel
def _push(row: Floats, neighbour: Floats, push: Floats) -> None:
    """Add the push (2,) [N; world] of one neighbour's jet, for a gain of one."""
    east, north = neighbour[NEIGHBOUR_FORCE], neighbour[NEIGHBOUR_FORCE + 1]
    force = math.sqrt(east * east + north * north)
    if force == 0.0:
        return
    jet_x, jet_y = -east / force, -north / force
    x, y, z = row[X] - neighbour[X], row[Y] - neighbour[Y], row[Z] - neighbour[Z]
    behind = x * jet_x + y * jet_y
    if behind <= 0.0:
        return
    across = (y * jet_x - x * jet_y) ** 2 + z * z
    width = JET_RADIUS + JET_SPREAD * behind
    felt = force * REFERENCE / max(behind, REFERENCE) * math.exp(-across / (width * width))
    push[0] += felt * jet_x
    push[1] += felt * jet_y


@kernel
def neighbour_wake(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the push of all neighbours, turned into the body."""
    (gain,) = unpack(parameters, 1)
    push = stack_array(2)
    for other in range(moment.neighbours.shape[0]):
        if other != moment.own:
            _push(row, moment.neighbours[other], push)
    sine, cosine = sine_cosine(row[YAW])
    total[0] += gain * (push[0] * cosine + push[1] * sine)
    total[1] += gain * (push[1] * cosine - push[0] * sine)


NEIGHBOUR_WAKE = Effect(
    summary="push by a neighbour's jet",
    opposite="pull by a neighbour's jet",
    equation="thrust of the neighbour * gain * 0.1 m / distance behind it",
    wrench=neighbour_wake,
    parameters=(
        Number(
            "gain",
            "1",
            "fraction of a neighbour's thrust that is felt 0.1 m behind it",
            multiplies="N",
            gives="N",
            search=Strength(large=0.6),
            between=(-1.0, 1.0),
            example=Example(0.2, "two robots in line"),
            other_form=0.15,  # jets that widen otherwise
        ),
    ),
    search=Search(channel="surge", manoeuvre="follow_neighbour"),
    check="Robots that swim into each other's jets: keep them further apart and compare.",
    neighbours=True,
)
