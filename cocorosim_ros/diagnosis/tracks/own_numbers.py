"""Numbers of single actuators, by their key in a platform's file, that have a column in the models of a diagnosis."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.diagnosis.tracks.columns import MOST_THRUSTERS
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.world.vehicle_model.fins import fin_numbers, fins_of
from cocorosim_ros.world.vehicle_model.rudders import OWN_NUMBERS, rudder_numbers, rudders_of


class Declared(NamedTuple):
    """A number as the platform's file has it, and its column in the rows of models."""

    column: str
    value: float  # SI


def gain_key(actuator: str) -> str:
    """The key of an actuator's own gain."""
    return f"actuators.{actuator}.gain"


def trim_key(actuator: str) -> str:
    """The key of the angle at which a rudder or fin stands at command zero."""
    return f"actuators.{actuator}.trim"


def own_numbers(platform: Platform) -> dict[str, Declared]:
    """Gains of thrusters and fins, numbers of rudders, trims that a model of the platform has, by key of its file."""
    numbers = rudder_numbers(platform)
    of_rudders = {
        f"actuators.{rudder.name}.{name}": Declared(f"{effect}.{name}", numbers[f"{effect}.{name}"])
        for effect, rudder in rudders_of(platform)
        for name in OWN_NUMBERS
    }
    of_each = fin_numbers(platform)
    of_fins = {
        f"actuators.{fin.name}.{name}": Declared(f"{effect}.{name}", of_each[f"{effect}.{name}"])
        for effect, fin in fins_of(platform)
        for name in ("gain", "trim")
    }
    return _own_gains(platform) | of_rudders | of_fins


def _own_gains(platform: Platform) -> dict[str, Declared]:
    """The gain of every thruster that has a column for it: of the first MOST_THRUSTERS."""
    thrusters = [each for each in platform.actuators if isinstance(each, Thruster)][:MOST_THRUSTERS]
    return {
        gain_key(each.name): Declared(f"own_gain.{number}", 1.0 if each.gain is None else each.gain)
        for number, each in enumerate(thrusters, 1)
    }
