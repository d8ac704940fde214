"""Numbers of effects that choose between forms: a platform file may have them in words, `form: own_speed` for 3.

The words of each stand in the order of its numbers, 0, 1, 2, ...
"""

from __future__ import annotations

from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import CONFIDENCES, SOURCE_KEYS, Quantity, is_quantity

WORDS: dict[str, tuple[str, ...]] = {
    "anisotropic_drag.form": ("total_speed", "added_own_speed", "added_strips", "own_speed", "strips"),
    "hull_compressibility.gas": ("elastic_hull", "gas"),
    "thruster_deadband.ramp": ("jump", "ramp"),
}
"""Words by EFFECT.NUMBER."""


def worded_number(key: str, entry: Entry) -> Quantity | None:
    """The number that a word says, bare or as {value: word, source: ...}; None where the number is not in words.

    key: EFFECT.NUMBER. Raises CocorosimError for a word that the number does not have, or one with a unit.
    """
    words = WORDS.get(key)
    stated = entry.value.get("value", entry) if isinstance(entry.value, dict) else entry
    if words is None or not isinstance(stated.value, str) or is_quantity(stated.value):
        return None
    if stated is not entry:
        section = entry.section(("value", "source"), SOURCE_KEYS)
        section["source"].text()
        if "confidence" in section:
            section["confidence"].choice(CONFIDENCES)
    return Quantity(float(words.index(stated.choice(words))), "1", "pure number")


def word_of(key: str, number: float) -> str | None:
    """The word for a number of an effect, None where it has none; key: EFFECT.NUMBER."""
    words = WORDS.get(key, ())
    return words[int(number)] if number in range(len(words)) else None
