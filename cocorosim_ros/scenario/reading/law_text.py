"""A law in words, as a platform file may have it: `surge: "-0.5 * |u| * u"` is a number times a product of regressors.

Which products there are is not known here; world.laws reads them.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import NUMBER, SOURCE_KEYS

BESIDE = ("range", "ci95")
"""Keys of what may stand beside the value of a law in words, beyond where it is from."""
_LAW = re.compile(rf"\s*({NUMBER})\s*\*\s*(\S.*?)\s*")


@dataclass(frozen=True)
class LawText:
    """A number in SI units, and the text of what it is times."""

    coefficient: float
    product: str

    @property
    def text(self) -> str:
        """The law as a file has it; the number comes back exactly."""
        return f"{self.coefficient!r} * {self.product}"


def is_law(value: Any) -> bool:
    """Whether a value is a law in words."""
    return parsed_law(value) is not None


def parsed_law(value: Any) -> LawText | None:
    """The law that a text says; None for other text and what is no text."""
    found = _LAW.fullmatch(value) if isinstance(value, str) else None
    return LawText(float(found[1]), found[2]) if found else None


def law_text(entry: Entry) -> LawText | None:
    """The law of an entry, text or {value: text, source: ...}; None for what is no law in words.

    A range or an interval beside it is one of its number, in SI units (reading.ranges). Raises CocorosimError for a law
    with a unit beside it, or without a source.
    """
    stated = entry.value.get("value", entry) if isinstance(entry.value, dict) else entry
    found = parsed_law(stated.value)
    if found is not None and stated is not entry:
        section = entry.section(("value", "source"), (*SOURCE_KEYS, *BESIDE))
        section["source"].text()
    return found
