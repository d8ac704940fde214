"""One train of waves on deep water, as this robot feels it: orbital velocity that moves with the crests.

The velocity itself is that of currents.waves, without a floor. A robot that moves meets the crests at another rate than
a fixed point does (frequency of encounter, Fossen 2021, equation 10.82), since the phase is that of its place.
Assumes: waves that are long beside the hull; what a wave does to a pressure gauge is left out.
Source: Dean and Dalrymple, Water Wave Mechanics (1991), equations 4.4 and 4.5 for great depth; k = omega^2 / g.
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


@kernel
def surface_waves(place: Floats, time: float, parameters: Floats, total: Floats) -> None:
    """Add the orbital velocity of the train: speed [m/s] at the surface, period [s], direction and phase [rad]."""
    speed, period, direction, phase = unpack(parameters, 4)
    omega = 2.0 * math.pi / period
    k = omega * omega / GRAVITY
    north, east = sine_cosine(direction)
    component = stack_array(6)
    component[0], component[1], component[2] = speed / omega, omega, k
    component[3], component[4], component[5] = k * east, k * north, phase
    add_component(place, time, math.inf, component, total)


def _periods(scene: Scene) -> list[float]:
    return sorted(set(scene.periods["waves"]))


def _directions(scene: Scene) -> list[float]:
    return [2.0 * math.pi * index / DIRECTIONS for index in range(DIRECTIONS)]


SURFACE_WAVES = Effect(
    summary="waves on the surface",
    equation="V_c = speed exp(k z) (cos(theta) along direction, sin(theta) up), theta = k s - omega t + phase",
    water=surface_waves,
    parameters=(
        Number(
            "speed",
            "m/s",
            "of the water at the surface, amplitude times frequency; crest to trough is speed * period / pi",
            gives="m/s",
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
            search=Grid(_periods, logarithmic=True),
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
    ),
    search=Search(channel="surge", water=True, group=MOVING_WATER, manoeuvre="four_headings", basis=phased("phase")),
    check="Wind, ships that pass, a tank's wave maker: watch the surface, and see whether it is calmer deeper down.",
)
