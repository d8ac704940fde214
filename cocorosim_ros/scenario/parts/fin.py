"""A control surface: a fin of a rudder's or a stern plane's kind."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.parts.direction import DIRECTION
from cocorosim_ros.scenario.parts.steering import ANGLE_OF_SURFACE
from cocorosim_ros.scenario.reading.records import TEXT, choice, quantity, vector


@dataclass(frozen=True)
class Fin:
    """A fin that turns as a whole; its command is its angle over the largest.

    position: of its centre of pressure [m; body]. direction: unit vector of the force that a positive angle gives where
    the vehicle moves ahead [body]. area: [m^2]. lift_slope: of the lift coefficient over the angle of attack [1/rad].
    largest_angle: [rad]. gain: what it gives as a multiple of all this, 1 if None. trim: angle at which it stands at
    command zero [rad], 0 if None.
    """

    name: str = field(metadata=TEXT)
    position: tuple[float, float, float] = field(metadata=vector("length", 3))
    direction: tuple[float, float, float] = field(metadata=DIRECTION)
    area: float = field(metadata=quantity("area", "positive"))
    lift_slope: float = field(metadata=quantity("inverse angle", "positive"))
    largest_angle: float = field(metadata=ANGLE_OF_SURFACE)
    gain: float | None = field(default=None, metadata=quantity("pure number", "positive"))
    trim: float | None = field(default=None, metadata=quantity("angle"))
    kind: Literal["fin"] = field(default="fin", metadata=choice("fin"))
