"""Probabilities as a reader takes them in: whole percents, the most probable first."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.catalogue.law_words import stream_words
from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect
from cocorosim_ros.diagnosis.report.words import effect_words
from cocorosim_ros.diagnosis.showing.probability import Probabilities, probabilities_of
from cocorosim_ros.diagnosis.showing.suspect_sets import AND_MORE, NO_EFFECT, SOMETHING_ELSE, TOGETHER

_UNSURE = {"100": "over 99", "0": "below 1"}
_OTHERS = "other such sets, each less probable"
_AS_THEY_ARE = (NO_EFFECT, SOMETHING_ELSE, AND_MORE)


def probability_words(told: Mapping[str, float]) -> str:
    """Words such as '97 % thruster lag, 2 % something else, 1 % nothing'; what rounds to 0 % is left out.

    Of many sets the most probable are told, and nothing; the others share one number.
    """
    shares = percents(list(told.values()))
    every = {_set_words(name): share for name, share in zip(told, shares, strict=True) if share}
    if len(every) == 1:
        return f"over 99\u00a0% {next(iter(every))}"
    shown = _foremost(every) if len(every) > REPORT.most_sets + 1 else list(every)
    left = sum(share for name, share in every.items() if name not in shown)
    words = [f"{every[name]}\u00a0% {name}" for name in shown]
    return ", ".join([*words, f"{left}\u00a0% {_OTHERS}"] if left else words)


def _foremost(every: Mapping[str, int]) -> list[str]:
    """The most probable of sets, by their percents, in their order, and nothing, wherever it stands."""
    foremost = sorted(every, key=lambda name: -every[name])[: REPORT.most_sets]
    return [name for name in every if name in foremost or name == NO_EFFECT]


def told_probabilities(diagnosis: Diagnosis) -> str:
    """Words for the probabilities of a diagnosis: of each name by itself and of sets, or of what silence hides."""
    found = probabilities_of(diagnosis)
    if not diagnosis.effects:
        return _of_silence(diagnosis, found.told)
    limit = ""
    if diagnosis.against is None and any(each.because for each in diagnosis.effects):
        limit = " (reasons for doubt, told in the warnings or beside a name, leave it no more than even odds)"
    return f"{_by_itself(diagnosis.effects, found)}{limit}; taken together {probability_words(found.grouped)}"


def meaning_words(diagnosis: Diagnosis) -> str:
    """Sentences on what the words beside the probabilities of sets mean; '' where no effect is named."""
    if not diagnosis.effects:
        return ""
    alike = "the vehicles are alike" if diagnosis.against else "the physics of the model is complete"
    meant = (
        f"Nothing: {alike}, but for numbers. Something else: what has no name, such as an unexplained force, and what "
        "is not in this list."
    )
    if f" and {AND_MORE}" not in probability_words(probabilities_of(diagnosis).grouped):
        return meant
    return f"{meant} And more: with others beside it, in sets that are not in this list."


def _by_itself(effects: Sequence[FoundEffect], found: Probabilities) -> str:
    """Words such as 'linear drag 98 %, tether 50 %, each whatever is there beside it'."""
    shares: dict[str, float] = {}
    for effect, share in zip(effects, found.of_effects, strict=True):
        name = _own_words(effect, effects)
        shares[name] = max(share, shares.get(name, 0.0))
    ordered = sorted(shares, key=lambda name: -shares[name])
    words = ", ".join(f"{name} {_percent(shares[name])}" for name in ordered)
    return f"{words}, each whatever is there beside it" if len(ordered) > 1 else words


def _own_words(effect: FoundEffect, others: Sequence[FoundEffect]) -> str:
    """Words for an effect, with its stream where others of that name are of other streams."""
    words = effect_words(effect.id)
    several = len({each.topic for each in others if each.id == effect.id}) > 1
    return f"{words} of {stream_words(effect.topic)}" if several and effect.topic else words


def _percent(share: float) -> str:
    whole = f"{100.0 * share:.0f}"
    return f"{_UNSURE.get(whole, whole)}\u00a0%"


def _of_silence(diagnosis: Diagnosis, told: Mapping[str, float]) -> str:
    """Words where nothing is named: something is hidden, nothing is there, or what comes nearest to a name is.

    A diagnosis may say all the same that something is there; then it is what has no name.
    """
    verb = "differs" if diagnosis.against else "is missing"
    near = [name for name in told if name not in (NO_EFFECT, SOMETHING_ELSE)]
    shares = [told[SOMETHING_ELSE], sum(told[name] for name in near), told[NO_EFFECT]]
    hidden, traces, nothing = percents(shares)
    shown = diagnosis.verdict == "mismatch"
    what = "that has no name" if shown else "which these recordings would not show"
    names = ", ".join(map(_set_words, near))
    said = [
        (hidden, f"that something {verb} {what}"),
        (nothing, f"that nothing {verb}"),
        (traces, f"that it is what they show a trace of, too weak for a name ({names})"),
    ]
    return ", ".join(f"{share}\u00a0% {words}" for share, words in said if share)


def percents(shares: Sequence[float]) -> list[int]:
    """Whole percents that add up to 100, none farther than one from its share (in all 1).

    The method of largest remainders: the percents that rounding down leaves over go where it took most.
    """
    exact = [100.0 * share for share in shares]
    whole = [math.floor(each) for each in exact]
    order = sorted(range(len(exact)), key=lambda place: whole[place] - exact[place])
    for place in order[: round(100.0 - sum(whole))]:
        whole[place] += 1
    return whole


def _set_words(name: str) -> str:
    """Words for a set of suspects."""
    members = name.split(TOGETHER)
    return " and ".join(each if each in _AS_THEY_ARE else effect_words(each) for each in members)
