"""The light in the tank: what robots may gather by."""

from __future__ import annotations

from dataclasses import dataclass, field

from cocorosim_ros.scenario.parts.vehicle_parts import Vector3
from cocorosim_ros.scenario.reading.records import TEXT, list_of, quantity, vector


@dataclass(frozen=True)
class Lamp:
    """A bright spot: position [m; world], illuminance there [lx], width of the bell curve around it [m]."""

    name: str = field(metadata=TEXT)
    position: Vector3 = field(metadata=vector("length", 3))
    illuminance: float = field(metadata=quantity("illuminance", "not negative"))
    width: float = field(metadata=quantity("length", "positive"))


@dataclass(frozen=True)
class Light:
    """All light: the same everywhere [lx], and lamps."""

    background: float = field(default=0.0, metadata=quantity("illuminance", "not negative"))
    lamps: tuple[Lamp, ...] = field(default=(), metadata=list_of(Lamp))
