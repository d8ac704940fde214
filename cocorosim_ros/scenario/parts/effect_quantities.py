"""The effects beyond the basic physics that a platform names, with their numbers or laws in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.law_text import LawText, law_text
from cocorosim_ros.scenario.reading.quantity import Quantity, read_any_quantity
from cocorosim_ros.scenario.reading.worded_numbers import worded_number

Effects = Mapping[str, Mapping[str, Quantity | LawText]]
"""{effect id: {parameter: number or law}}"""


def read_effects(entry: Entry) -> Effects:
    """The effects of a mapping, by their names; what each is, is checked elsewhere."""
    return {
        effect: {name: _read_part(f"{effect}.{name}", part) for name, part in parameters.mapping().items()}
        for effect, parameters in entry.mapping().items()
    }


def _read_part(key: str, entry: Entry) -> Quantity | LawText:
    return law_text(entry) or worded_number(key, entry) or read_any_quantity(entry)


def effects_tree(effects: Effects) -> dict[str, Any]:
    """The effects as nested plain values that `read_effects` reads back."""
    return {
        effect: {name: _part_text(part) for name, part in parameters.items()} for effect, parameters in effects.items()
    }


def _part_text(part: Quantity | LawText) -> str:
    return part.text if isinstance(part, LawText) else f"{part.value!r} {part.unit}"
