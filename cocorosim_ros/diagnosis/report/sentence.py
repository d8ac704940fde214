"""The summary of a diagnosis in a sentence or two."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Comparison, FoundEffect, HeldOut, Recalibrated, Verdict
from cocorosim_ros.diagnosis.report.number_text import estimate_words, in_unit_of, quantity_words


def sentence_of(
    verdict: Verdict, effects: Sequence[FoundEffect], moved: Sequence[Recalibrated], table: Mapping[str, HeldOut]
) -> str:
    """One plain sentence; for a mismatch the missing effects, their sizes, their rivals and the gain of the fit."""
    if verdict == "insufficient":
        return "These recordings do not excite the vehicle enough to tell what its model lacks."
    if verdict == "consistent":
        return "The model explains the recordings: nothing is missing that they could show."
    if verdict == "recalibrate":
        names = [
            f"{_plain(part.parameter)} {estimate_words(part.estimate)[0]} for {in_unit_of(part.nominal, part.estimate)}"
            for part in moved
        ]
        return f"Nothing is missing from the model, but its numbers have shifted: {_shortened(names)}."
    groups = {effect.robots for effect in effects}
    common = f" of {', '.join(effects[0].robots)}" if len(groups) == 1 and effects[0].robots else ""
    missing = ", and ".join(_effect(effect, named=not common) for effect in effects)
    return f"Missing from the model{common}: {missing}{_gain(table)}"


def difference_sentence(
    verdict: Verdict,
    effects: Sequence[FoundEffect],
    moved: Sequence[Recalibrated],
    against: Comparison,
    nameless: str = "",
) -> str:
    """One sentence about what differs from the recordings that are compared with, and whether those are alike.

    nameless: the law that explains what no entry of the catalogue does, "" for none.
    """
    count = len(against.recordings)
    begin = f"Compared with {count} recording{'s' if count > 1 else ''} of when it was well"
    if verdict == "insufficient":
        return f"{begin}: these recordings do not excite the vehicle enough to tell what differs."
    doubt = ""
    if against.control:
        doubt = f" These recordings differ among themselves too ({', '.join(map(_plain, against.control))})."
    if verdict == "consistent":
        return f"{begin}, nothing differs that these recordings could show.{doubt}"
    numbers = [
        f"{_plain(part.parameter)} {estimate_words(part.estimate)[0]} for {in_unit_of(part.nominal, part.estimate)}"
        for part in moved
    ]
    differing = [*numbers, *(_effect(effect, named=False) for effect in effects)]
    if nameless:
        differing.append("something that no entry of the catalogue explains")
    return f"{begin}, these differ: {', and '.join(differing)}.{doubt}"


def _effect(effect: FoundEffect, *, named: bool) -> str:
    numbers = [f"{_plain(name)} {estimate_words(value)[0]}" for name, value in effect.parameters.items()]
    told = [effect.correction] if effect.correction else [_shortened(numbers)] if numbers else []
    if effect.ambiguous_with:
        told.append(f"or else {' or '.join(_plain(rival.id) for rival in effect.ambiguous_with)}")
    robots = f" of {', '.join(effect.robots)}" if named and effect.robots else ""
    return f"{effect.name}{robots} ({'; '.join(told)})" if told else f"{effect.name}{robots}"


def _gain(table: Mapping[str, HeldOut]) -> str:
    """Words for the gain of the effects on the first channel of the table where they gain anything."""
    for channel, row in table.items():
        if row.augmented < REPORT.clear_gain * row.recalibrated:
            after, before, floor = (
                quantity_words(value, row.unit) for value in (row.augmented, row.recalibrated, row.noise_floor)
            )
            return f"; with it the error of {channel} on unseen data is {after} instead of {before} (floor {floor})."
    return "."


def _shortened(parts: Sequence[str]) -> str:
    more = len(parts) - REPORT.most_numbers
    return ", ".join(parts[: REPORT.most_numbers]) + (f" and {more} more" if more > 0 else "")


def _plain(name: str) -> str:
    return name.replace("_", " ")
