"""An entry of the catalogue: an effect by the contract's identifier, and how it is looked for."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from cocorosim_ros.world.terms.law import Law

SENSOR_CHANNELS = ("compass", "pressure", "imu", "pose", "clock", "velocity")
"""Channels of entries that act on what is read; all others act on the motion."""


class Scene(NamedTuple):
    """What the recordings span: lowest and highest x, y, z [m; world] and the duration [s].

    periods: at which the random force that the model needs swings most, by equation [s]. changes: moments at which
    that of heave steps most [s]. scales: typical sizes of the
    regressors of laws, of the forces by equation, and the mass [kg]. driven: whether thrusters moved the robots more
    than the water did at random.
    """

    lower: tuple[float, float, float]
    upper: tuple[float, float, float]
    duration: float
    hull: float  # length of the hull [m]
    arm: float  # how far the thrusters sit before the centre [m]
    periods: Mapping[str, tuple[float, ...]]
    changes: tuple[float, ...]
    scales: Mapping[str, float]
    driven: bool


@dataclass(frozen=True)
class Amplitude:
    """A number that is neutral where the effect is absent; `large` is its size in a bad case, the unit of its q.

    Its prior is a normal distribution with standard deviation `large` around neutral.
    """

    column: str
    name: str
    unit: str
    large: float
    step: float = 0.05  # of q, for slopes
    least: float = -math.inf  # of q
    most: float = math.inf
    neutral: float = 0.0
    negligible: tuple[float, float] = (0.0, 0.0)  # between these distances from neutral it is not believed, SI units
    adds_up: float = 0.0  # nor where this is all that it makes of the longest recording [SI units, s]
    searched: tuple[float, ...] = ()  # of q, ascending: where a fit may begin as well, if slopes do not lead far


@dataclass(frozen=True)
class Shape:
    """A number that says where, when or how; it has no meaning while the amplitudes are neutral.

    Looked for on a grid first; `spacing` is the unit of its q, between two points of the grid.
    """

    column: str
    name: str
    unit: str
    grid: Callable[[Scene], list[float]]
    logarithmic: bool = False
    fixed: bool = False  # looked for on the grid alone
    periodic: bool = False
    once: bool = False  # the moment of what happens once


Basis = Callable[[Mapping[str, float]], list[tuple[dict[str, float], float]]]
"""Function of the shapes by column: other shapes and the weight of the slope there."""


@dataclass(frozen=True)
class Entry:
    """One effect. `water`: of the water, so all robots of a recording share its numbers; else of each robot.

    fixed: numbers of the simulator's effect that are given, by column, from the scene.
    """

    id: str
    name: str
    equation: str  # in plain text
    channel: str  # the contract's equation: surge, sway, heave, yaw, compass, pressure, imu, pose, clock
    amplitudes: tuple[Amplitude, ...]
    shapes: tuple[Shape, ...] = ()
    water: bool = False
    group: str = ""  # effects that look alike are always compared with each other
    topic: str | None = None
    fixed: Mapping[str, Callable[[Scene], float]] = field(default_factory=dict)
    manoeuvre: str = ""  # a name in catalogue.manoeuvres
    needs_neighbours: bool = False
    basis: Basis | None = None  # how its slope at any shape is a sum of those at a few
    prior_nats: float = 0.0  # against it from the outset, for entries of which there are many
    of_pump: bool = False  # of how the pump answers its command, how the dive speed is resisted, or when depth is read
    law: str | None = None  # the place of the simulator that it takes, for laws outside the catalogue
    form: Law | None = None  # what such a law says
