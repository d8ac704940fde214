"""Laws of a platform file from words to the numbers that the simulator's effect has, and back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.reading.law_text import LawText
from cocorosim_ros.scenario.reading.quantity import Quantity
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.laws.law import Factor, Law, Product
from cocorosim_ros.world.laws.readings import READING, READINGS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS
from cocorosim_ros.world.terms.equations import EQUATION, EQUATIONS
from cocorosim_ros.world.terms.law_factors import LAW_FACTORS
from cocorosim_ros.world.terms.regressors import REGRESSORS

CODES = ("equation", "reading", *(part.name for part in LAW_FACTORS))
"""Numbers of a law that its words say."""
_USUAL = {part.name: part.neutral for part in LAW_FACTORS}


class InWords(NamedTuple):
    """What a law is of, and its coefficient with its product."""

    of: str
    law: LawText


def effects_of(platform: Platform) -> dict[str, dict[str, float]]:
    """The effects of a platform beyond the basic physics, in SI units, laws in words as numbers.

    Raises CocorosimError as `in_codes` does.
    """
    return in_codes(platform).effects


def in_codes(platform: Platform) -> Platform:
    """The platform with numbers for each of its laws in words.

    Raises CocorosimError where such a law stands below another effect, is of what no law is of, is one of several or
    stands beside numbers that say the same, or has a product that is none.
    """
    if not platform.laws:
        return platform
    effects = dict(platform.effect_quantities)
    for place, laws in platform.laws.items():
        told = f"{platform.origin}: 'effects.{place}.{next(iter(laws))}'"
        _check_place(place, laws, told)
        numbers = {name: part for name, part in effects[place].items() if name not in laws}
        doubled = [name for name in ("coefficient", *CODES) if name in numbers]
        if doubled:
            raise CocorosimError(f"{told} is a law in words, beside which stands '{doubled[0]}'; take one of them out.")
        ((of, law),) = laws.items()
        effects[place] = numbers | {name: Quantity(value, "1", "pure number") for name, value in _codes(of, law, told)}
    return replace(platform, effect_quantities=effects)


def in_words(numbers: Mapping[str, float]) -> InWords:
    """A law, by the numbers that the simulator's effect has, in words; numbers that are not given are usual ones."""
    given = {**_USUAL, **numbers}
    factors = [
        Factor(REGRESSORS[int(given[f"regressor_{n}"])].name, given[f"power_{n}"], given[f"signed_{n}"] != 0.0)
        for n in (1, 2)
    ]
    of = READINGS[int(given["reading"])].name if "reading" in given else EQUATIONS[int(given.get("equation", 0))].name
    return InWords(of, LawText(given["coefficient"], Product(*factors).text.replace("*", " * ")))


def _check_place(place: str, laws: Mapping[str, LawText], told: str) -> None:
    known = EQUATION if place in LAWS else READING if place in SENSOR_LAWS else {}
    if not known:
        raise CocorosimError(f"{told} is a law in words; write it below {', '.join((*LAWS, *SENSOR_LAWS))}.")
    if len(laws) > 1:
        raise CocorosimError(f"{told} is one of {len(laws)} laws; give each a place of its own.")
    if next(iter(laws)) not in known:
        raise CocorosimError(f"{told} is a law of nothing that '{place}' can be of; write one of {', '.join(known)}.")


def _codes(of: str, law: LawText, told: str) -> list[tuple[str, float]]:
    try:
        product = Product.parse(law.product.replace(" ", ""))
    except CocorosimError as error:
        raise CocorosimError(f"{told}: {error}") from None
    return [("coefficient", law.coefficient), *Law(of, product).codes.items()]
