"""Laws outside the catalogue in a platform file that is written: as `surge: "-0.5 * |u| * u"`, not as codes."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from cocorosim_ros.scenario.reading.law_text import LawText, parsed_law
from cocorosim_ros.scenario.reading.quantity import SOURCE_KEYS
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.laws.laws_of_platform import CODES, in_words
from cocorosim_ros.world.sensors.law import SENSOR_LAWS

Tree = dict[str, Any]


def laws_in_words(effects: Tree) -> Tree:
    """A copy of the effects of a platform file, as nested plain values, with each law in words.

    A law whose coefficient has a range stays as it is: a range is a number's.
    """
    return {name: _in_words(part) if name in (*LAWS, *SENSOR_LAWS) else part for name, part in effects.items()}


def _in_words(section: Tree) -> Tree:
    coefficient = section.get("coefficient")
    if coefficient is None or (isinstance(coefficient, dict) and "range" in coefficient):
        return section
    of, law = _law_of(section)
    origin = coefficient if isinstance(coefficient, dict) else {}
    stated = {"value": law.text} | {key: origin[key] for key in SOURCE_KEYS if key in origin}
    others = {name: part for name, part in section.items() if name not in ("coefficient", of, *CODES)}
    return {of: stated} | others


def _law_of(section: Tree) -> tuple[str, LawText]:
    """Find what the law is of, and the law with the coefficient that stands beside its words or codes."""
    value = _value(section["coefficient"])
    for name, part in section.items():
        known = parsed_law(part["value"] if isinstance(part, dict) else part)
        if known is not None:
            return name, replace(known, coefficient=value)
    return in_words({name: _value(section[name]) for name in ("coefficient", *CODES) if name in section})


def _value(part: Any) -> float:
    """The number of {value: ...}, of text with a unit, or of a bare number."""
    number = part["value"] if isinstance(part, dict) else part
    return float(str(number).split()[0])
