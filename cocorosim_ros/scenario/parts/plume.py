"""A substance that leaks into the water, as a scenario asks for it."""

from __future__ import annotations

from dataclasses import dataclass, field

from cocorosim_ros.scenario.parts.vehicle_parts import Vector3
from cocorosim_ros.scenario.reading.quantity import nanoseconds_text, read_nanoseconds
from cocorosim_ros.scenario.reading.records import TIME_FORM, quantity, stored, vector


@dataclass(frozen=True)
class Plume:
    """A source [m; world] that releases a substance at a steady rate [kg/s] in puffs, one every interval.

    diffusivity [m^2/s]: of the substance in the water, eddies that the currents do not show included.
    initial_size [m]: standard deviation of a new puff.
    """

    source: Vector3 = field(metadata=vector("length", 3))
    rate: float = field(metadata=quantity("mass rate", "positive"))
    diffusivity: float = field(metadata=quantity("area rate", "not negative"))
    initial_size: float = field(default=0.05, metadata=quantity("length", "positive"))
    interval_ns: int = field(
        default=5_000_000_000, metadata=stored(read_nanoseconds, nanoseconds_text, key="interval", form=TIME_FORM)
    )
