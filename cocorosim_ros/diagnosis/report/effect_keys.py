"""Keys of a platform file under which findings are written, so that simulator and next diagnosis read them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from cocorosim_ros.diagnosis.catalogue.eddies import EDDY
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.quantity import UNITS
from cocorosim_ros.world.effects import EFFECTS, LAWS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS
from cocorosim_ros.world.terms.law_places import EQUATIONS
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

BY_TOPIC = {"sensor_latency": "latency", "clock_skew": "skew"}
"""Effects that each topic may have: in a platform file the topic stands in place of the parameter."""
BESIDE = {"pressure_drift": {"offset": "pressure_offset"}}
"""Numbers that are found with an effect, and the effect below which a platform file has them."""
UNKNOWN = "unknown:"
_FACTOR = re.compile(r"(\|?)([a-z_0-9]+)\|?(?:\^(-?[0-9.]+))?")


def platform_effect(found: FoundEffect, known: Iterable[str]) -> str:
    """The name of an effect in a platform file; a law outside the catalogue takes a free place.

    known: the effects that are in the file. Raises CocorosimError if all places of laws are taken.
    """
    if found.simulated_as or not found.id.startswith(UNKNOWN):
        return found.simulated_as or found.id
    places = tuple(SENSOR_LAWS if found.topic is not None else LAWS)
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
    if found.id.startswith(UNKNOWN) and not found.simulated_as:
        return dict(found.settings) or law_numbers(found.id)
    known = EFFECTS[found.id].parameters if found.id in EFFECTS else ()  # an eddy has no others
    if found.settings:
        return {part.name: found.settings[part.name] for part in known if part.name in found.settings}
    return {part.name: duration for part in known if part.name == "duration" and part.name not in found.parameters}


def law_numbers(identifier: str) -> dict[str, float]:
    """The codes of 'unknown:<equation>~<regressor>': equation, and up to two regressors with their powers.

    |u|^0.5*u is the amount of u to the power 1.5, with the sign of u.
    """
    equation, _, product = identifier.removeprefix(UNKNOWN).partition("~")
    powers, signs = _powers_and_signs(product)
    numbers = {"equation": float(EQUATIONS.index(equation))}
    for place, name in enumerate((*[each for each in powers if each != "1"], "1", "1")[:2], 1):
        numbers |= {
            f"regressor_{place}": float(REGRESSOR_CODE[name]),
            f"power_{place}": powers.get(name, 1.0),
            f"signed_{place}": float(signs.get(name, True)),
        }
    return numbers


def unit_in_file(unit: str) -> str:
    """The unit as a platform file takes it; numbers of laws outside the catalogue have units that it has no name for.

    They stand there as pure numbers, in SI units.
    """
    return unit if any(unit in units for units in UNITS.values()) else "1"


def section_of(found: FoundEffect) -> str:
    """The key at the top of a platform file below which the effect stands."""
    return "effects" if found.correction is None else "frame_corrections"


def _powers_and_signs(product: str) -> tuple[Mapping[str, float], Mapping[str, bool]]:
    """Powers of the amounts of all regressors in a product, and flags that tell whether the signs count."""
    powers: dict[str, float] = {}
    signs: dict[str, bool] = {}
    for match in _FACTOR.finditer(product):
        bars, name, power = match.groups()
        powers[name] = powers.get(name, 0.0) + float(power or 1.0)
        signs[name] = signs.get(name, False) != (not bars and float(power or 1.0) % 2.0 == 1.0)
    return powers, signs
