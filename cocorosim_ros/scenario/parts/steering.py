"""Actuators that steer: a rudder, perhaps behind a propeller, and what turns a thruster about the vertical."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import quantity_text, read_quantity
from cocorosim_ros.scenario.reading.records import TEXT, choice, form_of, quantity, stored, vector

_Factor = float | None


def _read_rudder_angle(entry: Entry) -> float:
    angle = read_quantity(entry, "angle", "positive")
    if angle >= math.pi / 2:
        raise entry.problem(f"has {entry.found()}; rudders and fins turn by less than 90 deg to each side.")
    return angle


ANGLE_OF_SURFACE = stored(
    _read_rudder_angle, lambda value: quantity_text(value, "angle"), form=form_of("angle", "positive")
)
"""The rule of the largest angle of a rudder or fin [rad]."""


def _read_share(entry: Entry) -> float:
    share = read_quantity(entry, "pure number", "not negative")
    if share > 1.0:
        raise entry.problem(f"has {entry.found()}; write a fraction from 0 to 1.")
    return share


def _share() -> dict[str, object]:
    return stored(_read_share, lambda value: quantity_text(value, "pure number"), form="pure number from 0 to 1")


@dataclass(frozen=True)
class Rudder:
    """A rudder; its command is its angle over the largest, positive where it turns what goes ahead to the left.

    position: of its stock [m; body]. area: that moves [m^2]. aspect_ratio: height over mean chord. propeller: the
    thruster in whose jet it stands, of propeller_diameter [m]. trim: angle at which it stands at command zero [rad], 0
    if None. The other numbers below are explained where they act (world.effects.rudder); None stands for their value
    there without a hull and with the whole jet.
    """

    name: str = field(metadata=TEXT)
    position: tuple[float, float, float] = field(metadata=vector("length", 3))
    area: float = field(metadata=quantity("area", "positive"))
    aspect_ratio: float = field(metadata=quantity("pure number", "positive"))
    largest_angle: float = field(metadata=ANGLE_OF_SURFACE)
    propeller: str | None = field(default=None, metadata=TEXT)
    propeller_diameter: float | None = field(default=None, metadata=quantity("length", "positive"))
    gain: _Factor = field(default=None, metadata=quantity("pure number", "positive"))
    wake: _Factor = field(default=None, metadata=_share())
    acceleration: _Factor = field(default=None, metadata=quantity("pure number", "not negative"))
    coverage: _Factor = field(default=None, metadata=_share())
    straightening: _Factor = field(default=None, metadata=quantity("pure number", "not negative"))
    inflow_arm: _Factor = field(default=None, metadata=quantity("length"))
    drag_share: _Factor = field(default=None, metadata=quantity("pure number", "not negative"))
    hull_gain: _Factor = field(default=None, metadata=quantity("pure number", "not negative"))
    hull_position: _Factor = field(default=None, metadata=quantity("length"))
    trim: float | None = field(default=None, metadata=quantity("angle"))
    kind: Literal["rudder"] = field(default="rudder", metadata=choice("rudder"))


@dataclass(frozen=True)
class Azimuth:
    """What turns a thruster about the vertical; its command is the angle over the largest, counter-clockwise positive.

    thruster: the name of the one that it turns. At angle zero this pushes in its own `direction`.
    """

    name: str = field(metadata=TEXT)
    thruster: str = field(metadata=TEXT)
    largest_angle: float = field(metadata=quantity("angle", "positive"))
    kind: Literal["azimuth"] = field(default="azimuth", metadata=choice("azimuth"))
