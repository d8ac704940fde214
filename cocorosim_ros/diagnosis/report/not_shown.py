"""Section of the page on effects, streams and numbers that recordings cannot show, each with its smallest size."""

from __future__ import annotations

from typing import Any

from cocorosim_ros.diagnosis.findings import Diagnosis, NotLookedFor
from cocorosim_ros.diagnosis.report.believable import is_possible_size
from cocorosim_ros.diagnosis.report.sentence import shortened
from cocorosim_ros.diagnosis.report.words import effect_words, parameter_unit
from cocorosim_ros.foundation.units.quantity_text import quantity_words


def not_shown_context(diagnosis: Diagnosis) -> dict[str, Any]:
    """List effects that silence tells nothing about, `blind`, and the smallest size of each effect, `detectable`."""
    least = {each.id: _least(each.id, each.detectable) for each in diagnosis.screened} | _least_differences(diagnosis)
    # What needs a topic that was not recorded, or another robot, stands in diagnosis.json alone.
    tried = [name for name in diagnosis.not_shown if name in least or not least]
    return {
        "blind": [{"name": effect_words(name), "least": least.get(name, "")} for name in tried],
        "detectable": [{"name": effect_words(name), "least": words} for name, words in sorted(least.items())],
        "not_looked_for": [not_looked_for_words(each) for each in diagnosis.not_looked_for],
    }


def not_looked_for_words(each: NotLookedFor) -> str:
    """A sentence on an effect that was not looked for, with the keys of the numbers that would change that."""
    return f"Not looked for, since the platform does not give {shortened(each.numbers)}: {each.name}."


def _least_differences(diagnosis: Diagnosis) -> dict[str, str]:
    """Sizes from which differences would have been named, in words, by effect, effect:stream and effect:number."""
    seen = {} if diagnosis.against is None else diagnosis.against.seen_from
    least = {name: _least(name.partition(":")[0], numbers) for name, numbers in seen.items()}
    single = [name for name in diagnosis.not_shown if name not in least and name.rpartition(":")[0] in seen]
    for name in single:
        effect, _, number = name.rpartition(":")
        least[name] = _least(effect, {each: size for each, size in seen[effect].items() if each == number})
    return least


def _least(effect: str, detectable: Any) -> str:
    shown = [
        f"{name.replace('_', ' ')} {quantity_words(value, parameter_unit(effect, name))}"
        for name, value in detectable.items()
        if is_possible_size(effect, name, value, parameter_unit(effect, name))
    ]
    return ", ".join(shown)
