"""A mass that slides within the hull of a vehicle in six degrees of freedom, as gliders pitch and roll by."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.parts.direction import DIRECTION
from cocorosim_ros.scenario.reading.records import TEXT, choice, quantity


@dataclass(frozen=True)
class SlidingMass:
    """A part of the vehicle's own mass that slides; its command is how far it is from the middle over its travel.

    mass: of that part [kg]; the platform's mass and centre of gravity count it in the middle. direction: unit vector of
    the way that it takes at a positive command [body]. travel: that way at command 1, as at -1 the other way [m].
    """

    name: str = field(metadata=TEXT)
    mass: float = field(metadata=quantity("mass", "positive"))
    direction: tuple[float, float, float] = field(metadata=DIRECTION)
    travel: float = field(metadata=quantity("length", "positive"))
    kind: Literal["sliding_mass"] = field(default="sliding_mass", metadata=choice("sliding_mass"))
