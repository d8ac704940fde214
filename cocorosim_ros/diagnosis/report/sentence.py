"""The summary of a diagnosis: a headline of one short sentence, and below it the numbers, a line each."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import (
    Comparison,
    Diagnosis,
    FoundEffect,
    HeldOut,
    PassedOver,
    Recalibrated,
    Verdict,
)
from cocorosim_ros.diagnosis.report.number_text import estimate_words, in_unit_of, plain_number, quantity_words
from cocorosim_ros.diagnosis.report.significance import not_shown_numbers
from cocorosim_ros.diagnosis.report.words import effect_words

_NAMELESS = "something that no entry of the catalogue explains"


def sentence_of(
    verdict: Verdict,
    effects: Sequence[FoundEffect],
    moved: Sequence[Recalibrated],
    passed: Sequence[PassedOver] = (),
) -> str:
    """The headline of a diagnosis against a platform: one sentence of at most `REPORT.most_words` words.

    passed: what gets no name; told only where nothing has one.
    """
    if verdict == "insufficient":
        return "These recordings do not excite the vehicle enough to tell what its model lacks."
    if verdict == "consistent":
        return "The model explains the recordings: nothing is missing that they could show."
    if verdict == "recalibrate":
        begin = "Nothing is missing from the model, but its numbers have shifted:"
        return _as_many_as_fit(list(_numbers(moved)), lambda told: f"{begin} {told}.")
    if not effects:
        likeliest = max((each for each in passed if each.stands), key=lambda each: each.found.nats)
        return f"Something is missing, most like {likeliest.found.name}, but {likeliest.shortly}."
    whose = _whose(effects[0].robots) if len({each.robots for each in effects}) == 1 else ""
    certain, doubtful = ([each for each in effects if each.tier == tier] for tier in ("confirmed", "suspected"))
    if not certain:
        begin = f"Perhaps missing from the model{whose}:"
        return _as_many_as_fit([each.name for each in doubtful], lambda told: f"{begin} {told}.")
    begin = f"Missing from the model{whose}:"
    names = [*(each.name for each in certain), *(f"perhaps {each.name}" for each in doubtful)]
    return _as_many_as_fit(names, lambda told: f"{begin} {told}.")


def difference_sentence(
    verdict: Verdict,
    effects: Sequence[FoundEffect],
    moved: Sequence[Recalibrated],
    nameless: str = "",
    vague: Sequence[str] = (),
    either: Sequence[Sequence[str]] = (),
) -> str:
    """The headline of a comparison with recordings of the same vehicle when it was well: one sentence.

    nameless: the law that explains what no entry of the catalogue does, "" for none. vague: names of what differs by an
    amount that may as well be nothing. either: names of instruments' errors of which one or the other differs.
    """
    begin = "Compared with when it was well"
    if verdict == "insufficient":
        return f"{begin}: these recordings do not excite the vehicle enough to tell what differs."
    if verdict == "consistent":
        return f"{begin}, nothing differs that these recordings could show."
    names = [*_numbers(moved), *(each.name for each in effects), *([_NAMELESS] if nameless else [])]
    names += [f"most likely {effect_words(each)}, by how much cannot be told" for each in vague]
    names += [f"{' or '.join(map(effect_words, each))}, which of them cannot be told" for each in either]
    return _as_many_as_fit(list(dict.fromkeys(names)), lambda told: f"{begin}, these differ: {told}.")


def detail_lines(diagnosis: Diagnosis) -> tuple[str, ...]:
    """The lines below the headline: the size of each effect, shifted numbers, the gain, doubts about a comparison.

    Also what gets no name.
    """
    lines = [_effect(each) for each in diagnosis.effects]
    if diagnosis.verdict == "recalibrate" or diagnosis.against is not None:
        lines += [_shift(each) for each in diagnosis.recalibrated]
    without_name = map(_passed_over, diagnosis.passed_over)
    return (*lines, *_gain(diagnosis.fit), *_doubt(diagnosis.against), *without_name)


def _as_many_as_fit(names: Sequence[str], sentence: Callable[[str], str]) -> str:
    """The sentence with as many names as its words allow, but one at least; the others are counted."""
    for count in range(len(names), 1, -1):
        told = sentence(_listed(names[:count], len(names) - count))
        if len(told.split()) <= REPORT.most_words:
            return told
    return sentence(_listed(names[:1], len(names) - 1))


def _listed(names: Sequence[str], more: int) -> str:
    if more:
        return f"{'; '.join(names)}; and {more} more"
    return names[0] if len(names) == 1 else f"{'; '.join(names[:-1])}; and {names[-1]}"


def _robots(names: Sequence[str]) -> str:
    return ", ".join(names) if len(names) <= REPORT.most_robots else f"{len(names)} robots"


def _numbers(moved: Sequence[Recalibrated]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(_plain(part.parameter) for part in moved))


def _shift(part: Recalibrated) -> str:
    value = f"{estimate_words(part.estimate)[0]} for {in_unit_of(part.nominal, part.estimate)}"
    return f"{_plain(part.parameter)}{_whose(part.robots)}: {value}"


def _effect(effect: FoundEffect) -> str:
    doubtful = not_shown_numbers(effect)
    shown = [(name, value) for name, value in effect.parameters.items() if name not in doubtful]
    numbers = [f"{_plain(name)} {estimate_words(value)[0]}" for name, value in shown]
    told = [effect.correction] if effect.correction else [_shortened(numbers)] if numbers else []
    if effect.ambiguous_with:
        told.append(f"or else {' or '.join(_plain(rival.id) for rival in effect.ambiguous_with)}")
    name = f"{effect.name}{_whose(effect.robots)}, {effect.tier}"
    return f"{name}: {'; '.join(told)}" if told else name


def _passed_over(passed: PassedOver) -> str:
    found = passed.found
    told = {name: estimate_words(each) for name, each in found.parameters.items()}
    numbers = [f"{_plain(name)} {value} ({interval})" for name, (value, interval) in told.items()]
    size = f": {_shortened(numbers)}" if numbers else ""
    return (
        f"not named: {found.name}{_whose(found.robots)} ({plain_number(found.nats)} nats), since {passed.shortly}{size}"
    )


def _whose(robots: Sequence[str]) -> str:
    return f" of {_robots(robots)}" if robots else ""


def _gain(table: Mapping[str, HeldOut]) -> tuple[str, ...]:
    """Words for the gain of the effects on the first channel of the table where they gain anything."""
    for channel, row in table.items():
        if row.augmented < REPORT.clear_gain * row.recalibrated:
            after, before, floor = (
                quantity_words(value, row.unit) for value in (row.augmented, row.recalibrated, row.noise_floor)
            )
            return (f"error of {channel} on unseen data: {after} with it instead of {before} (floor {floor})",)
    return ()


def _doubt(against: Comparison | None) -> tuple[str, ...]:
    if against is None or not against.control:
        return ()
    return (f"the recordings compared with differ among themselves too: {', '.join(map(_plain, against.control))}",)


def _shortened(parts: Sequence[str]) -> str:
    more = len(parts) - REPORT.most_numbers
    return ", ".join(parts[: REPORT.most_numbers]) + (f" and {more} more" if more > 0 else "")


def _plain(name: str) -> str:
    return name.replace("_", " ")
