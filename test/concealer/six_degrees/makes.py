"""The vehicles with six degrees of freedom: what each is made of, and how it is driven.

`ROV`: a BlueROV2 Heavy as published: Wu, "6-DoF modelling and control of a remotely operated vehicle", Flinders
University 2018 (mass, buoyancy, added mass, drag); places of the thrusters from the manufacturer's drawing. Ballast
puts buoyancy 4 cm above the mass, so that it stays upright in all of its programmes.
`SLENDER`: a made AUV, a prolate spheroid of 1.4 m by 0.34 m that floats, with two propellers behind each other and four
tunnel thrusters. Mass and inertia: of the water it displaces, evenly spread, and of what it carries along (Lamb,
Hydrodynamics, article 114); drag across: strips with a coefficient of 0.8; drag ahead and linear drag are made up.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from concealer.layout import FloatArray
from concealer.six_degrees import layout as at

_H = math.sqrt(0.5)
Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Pilot:
    """How a vehicle is driven: largest demands, lengths of segments, and gains of what keeps it in its place."""

    demands: tuple[float, float, float]  # largest of surge, sway and yaw; [rad] of a heading that is held
    segment: tuple[float, float]  # s
    depths: tuple[float, float]  # m
    depth_time: tuple[float, float]  # s
    numbers: dict[int, float] = field(default_factory=dict)
    splits: tuple[float, ...] = ()  # shares by which one of two propellers does more; none without two


@dataclass(frozen=True)
class Make:
    """A vehicle: its numbers, its thrusters, its pilot."""

    robot: str
    mass: tuple[float, float, float]  # kg, with the water
    inertia: tuple[float, float, float]  # kg m^2, with the water
    linear: tuple[float, ...]  # N s/m and N m s
    quadratic: tuple[float, ...]  # kg/m and N m s^2
    lift: float  # N
    righting: float  # N m
    thrust: float  # N
    names: tuple[str, ...]
    places: Rows
    directions: Rows
    allocation: Rows
    full: tuple[float, float]  # N and N m, of which random forces are a fraction
    pilot: Pilot
    propeller: float = 0.0  # m, of thrusters that blow into each other

    def nominal(self) -> FloatArray:
        """(SIZE,) the vehicle as its platform file has it."""
        p = np.zeros(at.SIZE)
        p[at.MASS : at.MASS + 3], p[at.INERTIA : at.INERTIA + 3] = self.mass, self.inertia
        p[at.LINEAR : at.LINEAR + 6], p[at.QUADRATIC : at.QUADRATIC + 6] = self.linear, self.quadratic
        p[[at.LIFT, at.RIGHTING, at.THRUST, at.DURATION]] = self.lift, self.righting, self.thrust, 300.0
        p[[at.COUNT, at.PROPELLER]] = len(self.names), self.propeller
        for first, rows in ((at.PLACES, self.places), (at.DIRECTIONS, self.directions)):
            p[first : first + 3 * len(rows)] = np.ravel(rows)
        for number, row in enumerate(self.allocation):
            p[at.ALLOCATION + number * at.MOST :][: len(row)] = row
        for number, value in self.pilot.numbers.items():
            p[number] = value
        return p


ROV = Make(
    robot="rov_01",
    mass=(17.0, 24.2, 26.07),
    inertia=(0.28, 0.28, 0.28),
    linear=(4.03, 6.22, 5.18, 0.07, 0.07, 0.07),
    quadratic=(18.18, 21.66, 36.99, 1.55, 1.55, 1.55),
    lift=2.0,
    righting=0.04 * 114.8,
    thrust=40.0,
    names=(
        "front_right", "front_left", "rear_right", "rear_left",
        "up_front_right", "up_front_left", "up_rear_right", "up_rear_left",
    ),
    places=(
        (0.156, -0.111, 0.005), (0.156, 0.111, 0.005), (-0.156, -0.111, 0.005), (-0.156, 0.111, 0.005),
        (0.12, -0.218, 0.0), (0.12, 0.218, 0.0), (-0.12, -0.218, 0.0), (-0.12, 0.218, 0.0),
    ),
    directions=((_H, _H, 0.0), (_H, -_H, 0.0), (_H, -_H, 0.0), (_H, _H, 0.0), *4 * ((0.0, 0.0, 1.0),)),
    allocation=(
        (1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0), (1.0, -1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0), (1.0, -1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0),
    ),
    full=(113.0, 30.2),  # four thrusters at 45 degrees
    pilot=Pilot(
        demands=(0.15, 0.15, 0.05), segment=(1.5, 7.0), depths=(1.0, 4.0), depth_time=(12.0, 30.0),
        numbers={at.REACH: 4.0, at.HOME: 0.02, at.DEPTH: 0.1, at.CLIMB: 0.1, at.MOST_HEAVE: 0.06},
    ),
)  # fmt: skip

SLENDER = Make(
    robot="auv_01",
    mass=(91.4, 158.0, 158.0),
    inertia=(0.98, 14.25, 14.25),
    linear=(2.0, 8.0, 8.0, 0.3, 1.0, 1.0),
    quadratic=(11.0, 150.0, 150.0, 0.5, 8.7, 8.7),
    lift=1.0,
    righting=0.05 * 84.7 * at.GRAVITY,
    thrust=20.0,
    names=("main_front", "main_rear", "side_bow", "side_stern", "up_bow", "up_stern"),
    places=(
        (-0.75, 0.0, 0.0), (-0.95, 0.0, 0.0), (0.4, 0.0, 0.0), (-0.4, 0.0, 0.0), (0.5, 0.0, 0.0), (-0.5, 0.0, 0.0),
    ),
    directions=((1.0, 0.0, 0.0), (1.0, 0.0, 0.0), *2 * ((0.0, 1.0, 0.0),), *2 * ((0.0, 0.0, 1.0),)),
    allocation=(
        (1.0, 1.0, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 1.0, 1.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 0.0, 1.0, 1.0), (0.0, 0.0, 1.0, -1.0, 0.0, 0.0), (1.0, -1.0, 0.0, 0.0, 0.0, 0.0),
    ),
    full=(40.0, 16.0),
    pilot=Pilot(
        demands=(0.3, 0.3, math.pi), segment=(5.0, 20.0), depths=(2.0, 8.0), depth_time=(30.0, 60.0),
        numbers={
            at.REACH: 15.0, at.HOME: 0.02, at.HEADING: 0.4, at.TURN: 1.5,
            at.DEPTH: 0.15, at.CLIMB: 1.0, at.MOST_HEAVE: 0.3,
        },
        splits=(-1.0, 0.0, 1.0),
    ),
    propeller=0.2,
)  # fmt: skip

MAKES = {"rov": ROV, "slender": SLENDER}
