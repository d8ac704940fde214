"""The words in which an effect says how it is looked for: large sizes, grids, channels, groups, manoeuvres."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

DELAYS = (0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0)
"""Multiples of a large delay at which a fit may begin: the likelihood is too rough for slopes to lead there."""


class Scene(NamedTuple):
    """What the recordings span: lowest and highest x, y, z [m; world] and the duration [s].

    periods: at which the random force that the model needs swings most, by equation [s]. changes: moments at which
    that of heave steps most [s]. scales: typical sizes of the
    regressors of laws, of the forces by equation, and the mass [kg]. driven: whether thrusters moved the robots more
    than the water did at random. drag_form: of the vehicle's quadratic drag, a form of effects.anisotropic_drag.
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
    drag_form: float = 0.0
    above_water: tuple[float, float] = (0.0, 0.0)  # areas as seen from ahead and from the side [m^2]
    height: float = 0.0  # of the hull [m]
    weight: float = 0.0  # in air [N]
    cable: tuple[float, float] = (0.0, 0.0)  # its diameter and declared length [m]


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Bounds and steps of an amplitude, and the least that is believed; q is its distance from neutral over `large`."""

    step: float = 0.05  # of q, for slopes
    least: float = -math.inf  # of q
    most: float = math.inf  # of q
    negligible: tuple[float, float] = (0.0, 0.0)  # between these distances from neutral it is not believed, SI units
    adds_up: float = 0.0  # nor where this is all that it makes of the longest recording [SI units, s]
    searched: tuple[float, ...] = ()  # of q, ascending: where a fit may begin as well, if slopes do not lead far


@dataclass(frozen=True, kw_only=True)
class Spacing:
    """The layout of the points of a grid, and whether a fit goes on between them."""

    logarithmic: bool = False
    fixed: bool = False  # looked for on the grid alone
    periodic: bool = False
    once: bool = False  # the moment of what happens once
    swing: bool = False  # the time of a swing [s] or its rate [rad/s], which moves the phase at the end by much


@dataclass(frozen=True, kw_only=True)
class Strength(Limits):
    """An amplitude: a number that is neutral where the effect is absent; `large` is a bad case for a Lily, SI units.

    Its prior is a normal distribution with standard deviation `large` around neutral.
    """

    large: float


@dataclass(frozen=True)
class Grid(Spacing):
    """A shape: a number that says where, when or how, without a meaning while the amplitudes are neutral."""

    points: Callable[[Scene], list[float]]


class Given(NamedTuple):
    """A number that is not looked for: the recordings say what it is."""

    value: Callable[[Scene], float]


Basis = Callable[[Mapping[str, float]], list[tuple[dict[str, float], float]]]
"""Function of the shapes by name: other shapes and the weight of the slope there."""


@dataclass(frozen=True, kw_only=True)
class Standing:
    """The owner of an effect's numbers, and the effects that it is compared with.

    water: the effect is of the water, so that all robots of a recording share its numbers; else each has its own.
    """

    water: bool = False
    group: str = ""  # effects that look alike are always compared with each other; see terms.groups
    topic: str | None = None  # the stream of which the effect is, and without which it does not show
    basis: Basis | None = None  # how its slope at any shape is a sum of those at a few
    prior_nats: float = 0.0  # odds against it before any evidence: there are many of its sort, or it is rare
    of_pump: bool = False  # of how the pump answers its command, how the dive speed is resisted, or when depth is read


@dataclass(frozen=True, kw_only=True)
class Search(Standing):
    """The channel in which an effect shows, and the manoeuvre that shows it."""

    channel: str  # the equation that shows it: surge, sway, heave, yaw, compass, pressure, imu, pose, clock
    manoeuvre: str  # a name in diagnosis.catalogue.manoeuvres


def spread(low: float, high: float, count: int) -> list[float]:
    """The middles of so many equal parts of an interval."""
    return [low + (high - low) * (index + 0.5) / count for index in range(count)]
