"""One train of waves over a flat floor, as this robot feels it: orbital velocity that moves with the crests.

The velocity itself is that of currents.waves. Over a floor that is near beside their length, the water goes less up and
down than to and fro, and nearly as far at the floor as at the surface; a floor as far as BOTTOMLESS is none. A robot
that moves meets the crests at another rate than a fixed point does (frequency of encounter, Fossen 2021, equation
10.82), since the phase is that of its place.
Assumes: waves that are long beside the hull; what a wave does to a pressure gauge is left out.
Source: Dean and Dalrymple, Water Wave Mechanics (1991), equations 3.34 (omega^2 = g k tanh(k h)), 4.4 and 4.5; the
first guess of k is Eckart's, Proc. NBS Symposium on Gravity Waves (1951) 165.
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.unpacking import unpack
from cocorosim_ros.world.terms.effect import Effect, Example, Number
from cocorosim_ros.world.terms.groups import MOVING_WATER
from cocorosim_ros.world.terms.phases import phased, phases
from cocorosim_ros.world.terms.search import Grid, Scene, Search, Strength
from cocorosim_ros.world.water.currents.waves import add_component

GRAVITY = 9.80665  # m/s^2
DIRECTIONS = 8
BOTTOMLESS = 1000.0  # m
DEEP = 20.0  # omega^2 h / g from which on the floor is not felt to the last digit
ROUNDS = 5  # steps of Newton's method from a guess that errs by a twentieth
FLOORS = (1.2, 3.0)  # depths of the deepest place that was visited


@kernel
def wave_number(omega: float, depth: float) -> float:
    """Wave number [rad/m] of a frequency [rad/s] over a floor at this depth [m], by the dispersion relation."""
    deep = omega * omega / GRAVITY
    if deep * depth > DEEP:
        return deep
    k = deep / math.sqrt(math.tanh(deep * depth))
    for _ in range(ROUNDS):
        bent = math.tanh(k * depth)
        k -= (k * bent - deep) / (bent + k * depth * (1.0 - bent * bent))
    return k


@kernel
def surface_waves(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the orbital velocity of the train: speed [m/s] at the surface, period [s], direction, phase, floor."""
    speed, period, direction, phase, floor = unpack(parameters, 5)
    omega = 2.0 * math.pi / period
    k = wave_number(omega, floor)
    north, east = sine_cosine(direction)
    component = stack_array(6)
    component[0], component[1], component[2] = speed * math.tanh(k * floor) / omega, omega, k
    component[3], component[4], component[5] = k * east, k * north, phase
    add_component(place, time, floor, component, total)


def _periods(scene: Scene) -> list[float]:
    return sorted(set(scene.periods["waves"]))


def _directions(scene: Scene) -> list[float]:
    return [2.0 * math.pi * index / DIRECTIONS for index in range(DIRECTIONS)]


def _floors(scene: Scene) -> list[float]:
    """Depths of the water: none that is felt, and some below the deepest place."""
    deepest = max(-scene.lower[2], 0.1)
    return [BOTTOMLESS, *(share * deepest for share in FLOORS)]


SURFACE_WAVES = Effect(
    summary="waves on the surface",
    equation="V_c = speed (cosh(k (z + floor)) cos(theta) along direction, sinh(k (z + floor)) sin(theta) up) / "
    "cosh(k floor), theta = k s - omega t + phase, omega^2 = g k tanh(k floor)",
    water=surface_waves,
    parameters=(
        Number(
            "speed",
            "m/s",
            "of the water to and fro at the surface; over deep water crest to trough is speed * period / pi",
            gives="m/s",
            other_form=0.05,  # crests that are steeper than troughs, and waves of many periods
            search=Strength(large=0.007),
            example=Example(0.01, "drift"),
        ),
        Number(
            "period",
            "s",
            "from crest to crest at a fixed point",
            neutral=5.0,
            sign="positive",
            needed=True,
            multiplies="1/s",
            gives="1",
            search=Grid(_periods, logarithmic=True, swing=True),
            example=Example(4.0, "drift"),
        ),
        Number(
            "direction",
            "rad",
            "to which the crests go, counter-clockwise from x of the world",
            gives="rad",
            search=Grid(_directions, periodic=True),
            example=Example(0.7, "drift"),
        ),
        Number(
            "phase",
            "rad",
            "phase at the origin at time zero",
            gives="rad",
            search=Grid(phases, periodic=True),
            example=Example(0.5, "drift"),
        ),
        Number(
            "floor",
            "m",
            "depth of the water there; 1000 stands for water so deep that waves do not feel it",
            neutral=BOTTOMLESS,
            sign="positive",
            gives="m",
            search=Grid(_floors, logarithmic=True),
            example=Example(20.0, "chart"),
        ),
    ),
    search=Search(channel="surge", water=True, group=MOVING_WATER, manoeuvre="four_headings", basis=phased("phase")),
    check="Wind, ships that pass, a tank's wave maker: watch the surface, and see whether it is calmer deeper down.",
)
