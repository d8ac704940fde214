"""Keys of a platform file under which findings are written, so that simulator and next diagnosis read them."""

from __future__ import annotations

from collections.abc import Iterable

from cocorosim_ros.diagnosis.catalogue.eddies import EDDY
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.quantity import has_dimension
from cocorosim_ros.world.effects import EFFECTS, LAWS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS

BY_TOPIC = {name: error.streams.number for name, error in ERRORS.items() if error.streams is not None}
"""Effects that each topic may have for itself: there the topic stands in place of the parameter."""
BESIDE = {
    name: {part.name: other for other in error.beside for part in ERRORS[other].parameters}
    for name, error in ERRORS.items()
    if error.beside
}
"""Numbers that are found with an effect, and the effect below which a platform file has them."""


def platform_effect(found: FoundEffect, known: Iterable[str]) -> str:
    """The name of an effect in a platform file; a law outside the catalogue takes a free place.

    known: the effects that are in the file. Raises CocorosimError if all places of laws are taken.
    """
    if found.simulated_as or found.law is None:
        return found.simulated_as or found.id
    places = tuple(SENSOR_LAWS if found.law.topic is not None else LAWS)
    free = [place for place in places if place not in known]
    if not free:
        raise CocorosimError(
            f"A platform file has {len(places)} places for such laws outside the catalogue, and '{found.id}' is one "
            "more; take one of them out of the platform that is diagnosed."
        )
    return free[0]


def platform_parameters(found: FoundEffect) -> dict[str, Estimate]:
    """The numbers of an effect by the names that they have below the effect in a platform file."""
    if found.id in BY_TOPIC and found.topic is not None:
        return {found.topic: found.parameters[BY_TOPIC[found.id]]}
    if found.simulated_as == EDDY:
        return {"circulation" if name == "coefficient" else name: each for name, each in found.parameters.items()}
    elsewhere = BESIDE.get(found.id, {})
    return {name: each for name, each in found.parameters.items() if name not in elsewhere}


def parameters_beside(found: FoundEffect) -> dict[str, dict[str, Estimate]]:
    """The numbers that stand below other effects in a platform file, by effect and name."""
    beside: dict[str, dict[str, Estimate]] = {}
    for name, effect in BESIDE.get(found.id, {}).items():
        if name in found.parameters:
            beside.setdefault(effect, {})[name] = found.parameters[name]
    return beside


def fixed_numbers(found: FoundEffect, duration: float) -> dict[str, float]:
    """Numbers that the simulator needs beside those that were fitted: codes of a law, the recording's duration [s]."""
    if found.law is not None and not found.simulated_as:
        return dict(found.settings) or found.law.codes
    known = EFFECTS[found.id].parameters if found.id in EFFECTS else ()  # an eddy has no others
    if found.settings:
        return {part.name: found.settings[part.name] for part in known if part.name in found.settings}
    return {part.name: duration for part in known if part.name == "duration" and part.name not in found.parameters}


def unit_in_file(unit: str) -> str:
    """The unit as a platform file takes it; numbers of laws outside the catalogue have units that it has no name for.

    They stand there as pure numbers, in SI units.
    """
    return unit if has_dimension(unit) else "1"


def section_of(found: FoundEffect) -> str:
    """The key at the top of a platform file below which the effect stands."""
    return "effects" if found.correction is None else "frame_corrections"
