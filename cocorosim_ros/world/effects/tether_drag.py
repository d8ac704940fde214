"""Drag of a cable that the vehicle tows: F = -1/2 rho C_d d l integral_0^1 s |w| w ds, w = s V - V_c across the cable.

The cable runs straight from an anchor to the vehicle, and l is what is deployed of it: the distance, or the declared
length where that is longer. The share s of the cable, counted from the anchor, moves with s V over the ground and
through water of the velocity V_c; the vehicle bears the share s of the force there, the anchor the rest.
In still water F = -1/8 rho C_d d l |V| V: a quarter of the drag that all of the cable would have at the vehicle's
speed. A cable whose vehicle stands in a current pulls with F = 1/4 rho C_d d l |V_c| V_c, half of its drag.
A straight cable feels the flow across it alone (cross-flow principle). One that is longer than the distance D lies in
bends, inclined to its line by an angle a with cos a = D / l: along the line it has the share sin^3 a of its drag.
The integral is Gauss' with three points on either side of where the cable is slowest through the water: exact where V
and V_c are parallel, and within 3e-4 of the sum of the two special cases elsewhere.
Assumes: the same current all along; fresh water; no weight, inertia, friction along a straight cable or lag of its
bends; that it is fixed near the vehicle's centre, and that the force of a spring, if it has one, is that of `tether`.
Source: Christ and Wernli, The ROV Manual (2nd edition, 2014), chapter 3: drag of a tether by its diameter, its length
across the flow and C_d = 1.2; Hoerner, Fluid-Dynamic Drag (1965), chapter 3: cross-flow, sin^3 of the angle.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import SURGE, YAW, X, Y, Z
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import DRAG
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Given, Grid, Scene, Search, Strength, spread

WATER = 1000.0  # kg/m^3
POINTS = (0.5 - math.sqrt(0.15), 0.5, 0.5 + math.sqrt(0.15))  # Gauss and Legendre's of three points, on (0, 1)
WEIGHTS = (5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0)


@kernel
def _line(row: Floats, east: float, north: float, up: float, line: Floats) -> float:
    """Write the direction (3,) [body] from the anchor to the vehicle, that far off [m; world]; return the distance."""
    distance = math.sqrt(east * east + north * north + up * up)
    if distance > 0.0:
        sine, cosine = sine_cosine(row[YAW])
        line[0] = (east * cosine + north * sine) / distance
        line[1] = (north * cosine - east * sine) / distance
        line[2] = up / distance
    return distance


@kernel
def _less_along(velocity: Floats, line: Floats, taken: float) -> None:
    """Take away, in place, a share of what a velocity (3,) has along a line."""
    along = velocity[0] * line[0] + velocity[1] * line[1] + velocity[2] * line[2]
    for axis in range(3):
        velocity[axis] -= taken * along * line[axis]


@kernel
def _add_part(low: float, high: float, ground: Floats, water: Floats, total: Floats) -> None:
    """Add the integral (3,) [m^2/s^2] of s |w| w over a part of the cable."""
    for point in range(3):
        share = low + (high - low) * POINTS[point]
        squared = 0.0
        for axis in range(3):
            squared += (share * ground[axis] - water[axis]) ** 2
        weight = (high - low) * WEIGHTS[point] * share * math.sqrt(squared)
        for axis in range(3):
            total[axis] += weight * (share * ground[axis] - water[axis])


@kernel
def tether_drag(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the vehicle's share of the cable's drag."""
    coefficient, diameter, length, x, y, z = unpack(parameters, 6)
    line, ground, water, felt = stack_array(3), stack_array(3), stack_array(3), stack_array(3)
    distance = _line(row, row[X] - x, row[Y] - y, row[Z] - z, line)
    deployed = max(distance, length)
    if deployed <= 0.0:
        return
    # |w| w goes by the square of w: the root of sin^3 a is what is left of it along the line.
    taken = 1.0 - (1.0 - (distance / deployed) ** 2) ** 0.75
    for axis in range(3):
        ground[axis] = row[SURGE + axis]
        water[axis] = row[SURGE + axis] - relative[axis]
    _less_along(ground, line, taken)
    _less_along(water, line, taken)
    squared, common = 0.0, 0.0
    for axis in range(3):
        squared += ground[axis] * ground[axis]
        common += ground[axis] * water[axis]
    slowest = min(max(common / squared, 0.0), 1.0) if squared > 0.0 else 0.0
    _add_part(0.0, slowest, ground, water, felt)
    _add_part(slowest, 1.0, ground, water, felt)
    for axis in range(3):
        total[axis] -= 0.5 * WATER * coefficient * diameter * deployed * felt[axis]


def _places_along(axis: int, scene: Scene) -> list[float]:
    """Places of the anchor: over what was driven through, and beyond by three times its length, width or depth."""
    reach = 3.0 * max(high - low for low, high in zip(scene.lower, scene.upper, strict=True))
    return spread(scene.lower[axis] - reach, scene.upper[axis] + reach, 9)


TETHER_DRAG = Effect(
    summary="drag of a towed cable",
    equation="F = -1/2 rho C_d d l integral of s |s V - V_c| (s V - V_c) ds across the cable",
    wrench=tether_drag,
    parameters=(
        Number(
            "coefficient",
            "1",
            "drag coefficient of the cable across the flow, about 1.2",
            sign="not negative",
            multiplies="N",
            gives="N",
            search=Strength(large=1.2, least=0.0),
            other_form=0.04,  # a bow is longer than the line below it
            example=Example(1.2, "cylinder across the flow"),
        ),
        Number(
            "diameter",
            "m",
            "of the cable",
            sign="positive",
            needed=True,
            gives="m",
            search=Given(lambda scene: scene.cable[0]),
            example=Example(0.0076, "data sheet"),
        ),
        Number(
            "length",
            "m",
            "that is deployed, where it is longer than the distance",
            sign="not negative",
            gives="m",
            search=Given(lambda scene: scene.cable[1]),
            example=Example(0.0, "taut cable"),
        ),
        Number(
            "x",
            "m",
            "the anchor, in the world",
            gives="m",
            search=Grid(lambda scene: _places_along(0, scene)),
            other_place=0.25,  # a cable in a bow of a tenth of its length ends 0.4 rad beside its line
            example=Example(0.5, "where it is tended from"),
        ),
        Number(
            "y",
            "m",
            "the anchor, in the world",
            gives="m",
            search=Grid(lambda scene: _places_along(1, scene)),
            other_place=0.25,  # a cable in a bow of a tenth of its length ends 0.4 rad beside its line
            example=Example(0.0, "where it is tended from"),
        ),
        Number(
            "z",
            "m",
            "the anchor, in the world; 0 at the surface",
            gives="m",
            search=Given(lambda scene: 0.0),
            example=Example(0.0, "where it is tended from"),
        ),
    ),
    search=Search(channel="surge", group=DRAG, manoeuvre="four_headings"),
    needs=("cable",),
    check="Pay out less cable, or tend it from another place, and compare; see where it lies in the water.",
)
