"""Wind on what stands above the water: X = 1/2 rho_a A_x |V| V_x, Y = 1/2 rho_a A_y |V| V_y, N = arm Y, in body axes.

V is the velocity of the air relative to the vehicle, A_x and A_y the areas ahead and to the side times their
coefficients. What still air would do is taken off, because the drag in the water, as it is measured, holds it.
Assumes: air of 1.225 kg/m^3; a wind that is the same everywhere and at all times.
Source: Fossen (2021), section 10.1, with C_X = -c_x cos(gamma), C_Y = c_y sin(gamma); c_x = 0.7 and c_y = 0.85 are in
the middle of the ranges given there. His moment goes by sin(2 gamma); here the side has one centre.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.state.state import SURGE, SWAY, YAW
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import MOVING_WATER
from cocorosim_ros.world.terms.moment import Moment
from cocorosim_ros.world.terms.search import Given, Grid, Scene, Search, Strength

AIR = 1.225  # kg/m^3
AHEAD, ASIDE = 0.7, 0.85  # c_x, c_y


@kernel
def wind(row: Floats, relative: Floats, moment: Moment, parameters: Floats, total: Floats) -> None:
    """Add the force of the wind less that of still air."""
    x, y, front, side, arm = unpack(parameters, 5)
    sine, cosine = sine_cosine(row[YAW])
    ahead = x * cosine + y * sine - row[SURGE]
    aside = y * cosine - x * sine - row[SWAY]
    blowing = math.sqrt(ahead * ahead + aside * aside)
    still = math.sqrt(row[SURGE] * row[SURGE] + row[SWAY] * row[SWAY])
    across = 0.5 * AIR * side * (blowing * aside + still * row[SWAY])
    total[0] += 0.5 * AIR * front * (blowing * ahead + still * row[SURGE])
    total[1] += across
    total[3] += arm * across


def _arms(scene: Scene) -> list[float]:
    """Places of the centre of the side above the water: it is rarely farther from the middle than a seventh."""
    return [share * scene.hull for share in (-0.15, -0.05, 0.05, 0.15)]


WIND = Effect(
    summary="wind",
    equation="F = 1/2 rho_a A |V_w - V| (V_w - V) less that in still air",
    wrench=wind,
    parameters=(
        Number(
            "x",
            "m/s",
            "velocity of the air along x of the world",
            gives="m/s",
            other_form=0.06,  # c_x and c_y from end to end of their ranges, and areas of a drawing; by the square root
            part="V_wx = x",
            search=Strength(large=0.3),
            example=Example(1.5, "anemometer"),
        ),
        Number(
            "y",
            "m/s",
            "velocity of the air along y of the world",
            gives="m/s",
            other_form=0.06,  # as for x
            part="V_wy = y",
            search=Strength(large=0.3),
            example=Example(-0.5, "anemometer"),
        ),
        Number(
            "front",
            "m^2",
            "area above the water as seen from ahead, times its coefficient",
            sign="not negative",
            multiplies="Pa",
            gives="N",
            search=Given(lambda scene: AHEAD * scene.above_water[0]),
            example=Example(0.002, "drawing"),
        ),
        Number(
            "side",
            "m^2",
            "area above the water as seen from the side, times its coefficient",
            sign="not negative",
            multiplies="Pa",
            gives="N",
            search=Given(lambda scene: ASIDE * scene.above_water[1]),
            example=Example(0.004, "drawing"),
        ),
        Number(
            "arm",
            "m",
            "centre of the side above the water before the centre",
            gives="m",
            search=Grid(_arms),
            example=Example(0.01, "drawing"),
        ),
    ),
    search=Search(channel="sway", water=True, group=MOVING_WATER, manoeuvre="four_headings"),
    needs=("above_water",),
    check="Measure the wind where the vehicle was, and compare calm days with windy ones.",
)
