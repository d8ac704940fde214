"""Probabilities as a reader takes them in: whole percents, the most probable first."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.diagnosis.report.words import effect_words
from cocorosim_ros.diagnosis.showing.probability import probabilities_of
from cocorosim_ros.diagnosis.showing.suspect_sets import NO_EFFECT, SOMETHING_ELSE, TOGETHER


def probability_words(told: Mapping[str, float]) -> str:
    """Words such as '97 % thruster lag, 2 % something else, 1 % nothing'; what rounds to 0 % is left out."""
    names = [_set_words(name) for name in told]
    shown = [(name, share) for name, share in zip(names, percents(list(told.values())), strict=True) if share]
    if len(shown) == 1:
        return f"over 99\u00a0% {shown[0][0]}"
    return ", ".join(f"{share}\u00a0% {name}" for name, share in shown)


def told_probabilities(diagnosis: Diagnosis) -> str:
    """Words for the probabilities of a diagnosis, with what keeps those of names low."""
    words = probability_words(probabilities_of(diagnosis).told)
    if any(found.because for found in diagnosis.effects):
        return f"{words} (what speaks against this fit keeps a name at even odds, whatever its evidence)"
    return words


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
    return " and ".join(each if each in (NO_EFFECT, SOMETHING_ELSE) else effect_words(each) for each in members)
