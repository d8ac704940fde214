"""Waves at the surface, as a scenario asks for them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.reading.records import choice, quantity


@dataclass(frozen=True)
class Waves:
    """A sea by its significant height [m], the period of its peak [s], and where it goes to [rad; world, from +x].

    peakedness: gamma of JONSWAP, 1 for a sea that is fully grown (Pierson and Moskowitz). depth: of the sea [m], which
    decides how long waves are; None: of the tank.
    """

    height: float = field(metadata=quantity("length", "positive"))
    period: float = field(metadata=quantity("time", "positive"))
    direction: float = field(default=0.0, metadata=quantity("angle"))
    peakedness: float = field(default=3.3, metadata=quantity("pure number", "positive"))
    depth: float | None = field(default=None, metadata=quantity("length", "positive"))
    kind: Literal["waves"] = field(default="waves", metadata=choice("waves"))
