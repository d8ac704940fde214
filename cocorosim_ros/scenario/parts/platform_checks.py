"""Checks of a platform's sensors and effects against what a simulation knows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.parameter import Parameter
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.entry import nearest
from cocorosim_ros.scenario.reading.law_text import LawText
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of


def check_sensors(platform: Platform, known: Iterable[str]) -> None:
    """Nothing, if every sensor that the platform names is one of `known`. Raises CocorosimError otherwise."""
    topics = list(known)
    for topic in platform.sensors.further:
        if topic not in topics:
            raise CocorosimError(f"{platform.origin}: 'sensors.{topic}' is no known sensor{nearest(topic, topics)}.")


def check_effects(platform: Platform, known: Mapping[str, Mapping[str, Parameter]]) -> None:
    """Nothing, if every effect of the platform is known, has the parameters that it needs, and all of them fit.

    known: {effect id: {name: parameter}}. Raises CocorosimError otherwise, and for a law that is still in words.
    """
    for effect, numbers in platform.effect_quantities.items():
        place = f"{platform.origin}: 'effects.{effect}'"
        if effect not in known:
            raise CocorosimError(f"{place} is no known effect{nearest(effect, known)}.")
        for name, number in numbers.items():
            if name not in known[effect]:
                raise CocorosimError(
                    f"{place[:-1]}.{name}' is no parameter of this effect{nearest(name, known[effect])}."
                )
            if isinstance(number, LawText):
                raise CocorosimError(f"{place[:-1]}.{name}' is a law in words where a number is needed; write one.")
            _check_number(f"{place[:-1]}.{name}'", number, known[effect][name])
        for name, parameter in known[effect].items():
            if parameter.needed and name not in numbers:
                raise CocorosimError(f"{place} lacks '{name}' ({parameter.meaning}); add it, in {parameter.unit}.")


def _check_number(place: str, number: Quantity, parameter: Parameter) -> None:
    dimension = number.dimension if parameter.unit == "*" else dimension_of(parameter.unit)  # *: as the law has it
    shown = f"{place} has '{number.value!r} {number.unit}'"
    if number.dimension != dimension:
        raise CocorosimError(f"{shown}, which is no {dimension}; write it in {parameter.unit}.")
    if parameter.sign == "positive" and number.value <= 0.0:
        raise CocorosimError(f"{shown}; it must be greater than zero.")
    if parameter.sign == "not negative" and number.value < 0.0:
        raise CocorosimError(f"{shown}; it must not be negative.")
