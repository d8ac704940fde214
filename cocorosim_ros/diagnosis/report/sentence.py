"""The lines below the headline of a diagnosis: numbers of what was found, gains, doubts, what gets no name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import (
    Comparison,
    Diagnosis,
    FoundEffect,
    HeldOut,
    PassedOver,
    Recalibrated,
)
from cocorosim_ros.diagnosis.report.headline import plain, whose_words
from cocorosim_ros.diagnosis.report.marks import marked_value, marked_words, unlike_words
from cocorosim_ros.diagnosis.report.number_text import in_unit_of
from cocorosim_ros.diagnosis.report.significance import may_be_nothing, not_shown_numbers
from cocorosim_ros.diagnosis.report.words import effect_words
from cocorosim_ros.diagnosis.showing.doubt import SIZE_MAY_BE_NOTHING
from cocorosim_ros.foundation.units.quantity_text import plain_number, quantity_words


def detail_lines(diagnosis: Diagnosis) -> tuple[str, ...]:
    """The lines below the headline: the size of each effect, shifted numbers, the gain, doubts about a comparison.

    Also what gets no name; and the reasons, where nothing could be tested.
    """
    reasons = [each for each in diagnosis.reasons if each != diagnosis.sentence]
    lines = [_effect(each) for each in diagnosis.effects]
    if diagnosis.verdict == "recalibrate" or diagnosis.against is not None:
        lines += [_shift(each) for each in diagnosis.recalibrated]
    without_name = map(_passed_over, diagnosis.passed_over)
    return (*reasons, *lines, *_gain(diagnosis.fit, diagnosis.unlike), *_doubt(diagnosis.against), *without_name)


def _shift(part: Recalibrated) -> str:
    value = f"{marked_value(part.estimate)} for {in_unit_of(part.nominal, part.estimate)}"
    return f"{parameter_words(part.parameter)}{whose_words(part.robots)}: {value}"


def _effect(effect: FoundEffect) -> str:
    doubtful = not_shown_numbers(effect)
    shown = [(name, value) for name, value in effect.parameters.items() if name not in doubtful]
    numbers = [f"{plain(name)} {marked_value(value)}" for name, value in shown]
    told = [effect.correction] if effect.correction else [shortened(numbers)] if numbers else []
    if effect.ambiguous_with:
        told.append(f"or else {' or '.join(effect_words(rival.id) for rival in effect.ambiguous_with)}")
    doubt = f", and {SIZE_MAY_BE_NOTHING}" if may_be_nothing(effect) else ""
    name = f"{effect.name}{whose_words(effect.robots)}, {effect.tier}{doubt}"
    return f"{name}: {'; '.join(told)}" if told else name


def _passed_over(passed: PassedOver) -> str:
    found = passed.found
    told = {name: marked_words(each) for name, each in found.parameters.items()}
    numbers = [f"{plain(name)} {value} ({interval})" for name, (value, interval) in told.items()]
    size = f": {shortened(numbers)}" if numbers else ""
    name = f"{found.name}{whose_words(found.robots)}"
    return f"not named: {name} ({plain_number(found.nats)} nats), since {passed.shortly}{size}"


def _gain(table: Mapping[str, HeldOut], unlike: Sequence[str]) -> tuple[str, ...]:
    """Words for the gain of the effects on the first channel of the table where they gain anything."""
    for channel, row in table.items():
        if row.augmented < REPORT.clear_gain * row.recalibrated:
            after, before, nameless = (
                quantity_words(value, row.unit) for value in (row.augmented, row.recalibrated, row.noise_floor)
            )
            beside = f"; these data are {unlike_words(unlike)}" if unlike else ""
            return (
                f"error of {channel} on unseen data: {after} with it instead of {before} (with a force without a name "
                f"{nameless}){beside}",
            )
    return ()


def _doubt(against: Comparison | None) -> tuple[str, ...]:
    if against is None or not against.control:
        return ()
    return (
        f"the recordings compared with differ among themselves too: {', '.join(map(effect_words, against.control))}",
    )


def shortened(parts: Sequence[str]) -> str:
    """The first few of some parts, and how many more there are."""
    more = len(parts) - REPORT.most_numbers
    return ", ".join(parts[: REPORT.most_numbers]) + (f" and {more} more" if more > 0 else "")
