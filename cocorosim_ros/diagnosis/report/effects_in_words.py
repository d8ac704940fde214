"""Effects of a platform file in words, not as codes: `surge: "-0.5 * |u| * u"`, `form: own_speed`."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.scenario.reading.law_text import BESIDE, LawText, parsed_law
from cocorosim_ros.scenario.reading.quantity import SOURCE_KEYS, read_any_quantity
from cocorosim_ros.scenario.reading.worded_numbers import WORDS, word_of
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.laws.laws_of_platform import CODES, in_words
from cocorosim_ros.world.sensors.law import SENSOR_LAWS

Tree = dict[str, Any]


def effects_in_words(effects: Tree) -> Tree:
    """A copy of the effects of a platform file, as nested plain values, in words: laws, and numbers that choose a form.

    The range of a law's coefficient goes with the law, and then its interval too, in SI units.
    """
    return {
        effect: _law_in_words(part) if effect in (*LAWS, *SENSOR_LAWS) else _numbers_in_words(effect, part)
        for effect, part in effects.items()
    }


def _numbers_in_words(effect: str, section: Tree) -> Tree:
    return {name: _in_word(f"{effect}.{name}", part) for name, part in section.items()}


def _in_word(key: str, part: Any) -> Any:
    """A number as its word, with where it is from; as it stands where it is in words already, or has none."""
    stated = part["value"] if isinstance(part, dict) else part
    if key not in WORDS or stated in WORDS[key]:
        return part
    word = word_of(key, _si(part, stated))
    if word is None:
        return part
    origin = {name: part[name] for name in SOURCE_KEYS if name in part} if isinstance(part, dict) else None
    return word if origin is None else {"value": word} | origin


def _law_in_words(section: Tree) -> Tree:
    coefficient = section.get("coefficient")
    if coefficient is None:
        return section
    of, law = _law_of(section)
    origin = coefficient if isinstance(coefficient, dict) else {}
    stated: Tree = {"value": law.text} | {key: origin[key] for key in SOURCE_KEYS if key in origin}
    if "range" in origin:
        stated |= {key: [_si(coefficient, end) for end in origin[key]] for key in BESIDE if key in origin}
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
    """The number of {value: ..., unit: ...}, of text with a unit, or of a bare number, in SI units."""
    return _si(part, part["value"] if isinstance(part, dict) else part)


def _si(part: Any, number: Any) -> float:
    """A number in SI units that is given in the unit of `part`."""
    if isinstance(part, dict):
        number = f"{number} {part.get('unit', '1')}"
    return read_any_quantity(entry_of(number, "the model")).value if isinstance(number, str) else float(number)
