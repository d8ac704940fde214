"""Probabilities of what the model lacks: by set of suspects, with "something else" and "nothing", in all 1.

What is asked is which effects the platform's model lacks; numbers of the platform that have moved are no effect. Every
named effect is a question with four answers, whose weights are

    it is there                          1
    a rival is there in its place        exp(-temper * nats behind)
    something that has no name here is   unnamed
    nothing is                           chance + exp(-temper * (nats - threshold))

so that at the threshold of naming an effect is about as likely as nothing, and every nat beyond makes it likelier. Nats
are tempered, because a likelihood that holds for one exact model is too sure where no model is exact (Grünwald and
van Ommen, Bayesian Analysis 12 (2017) 1069). The last question is what has been passed over: nothing has the weight 1,
something else `missing` or `further` times the share of effects that these recordings would not show (`hidden_share`);
where evidence or free runs stand for something that gets no name, both are as probable as what a hard stop speaks
against.
Where nothing was named, an entry of the catalogue that explains something has exp(temper * (nats - threshold)), so that
none is more probable than nothing; its nats do not count if they would have sufficed: then it was fitted, and did not
hold what its slope had promised. The answers are taken as independent. All weights are fields of
`criteria.probability`, fitted to sealed recordings: so these are probabilities among recordings like those.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.probability import PROBABILITY, ProbabilityCriteria
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect, ScreenedEffect
from cocorosim_ros.diagnosis.showing.suspect_sets import (
    NO_EFFECT,
    SOMETHING_ELSE,
    Answers,
    by_first_of,
    told_sets,
)
from cocorosim_ros.world.laws.law import is_law


@dataclass(frozen=True)
class Probabilities:
    """Probabilities by set of suspects, the most probable first, and of each named effect by itself.

    told: sets are identifiers with " + " between them; SOMETHING_ELSE holds every set that is not told, NO_EFFECT that
    the model lacks nothing; in all 1. of_effects: for each named effect that it is there, whatever is there beside it;
    of a law outside the catalogue, that something without a name is there in its place. grouped: as told, but sets
    that are not told are those of the most probable named effect in them, with AND_MORE; SOMETHING_ELSE has the others.
    """

    told: Mapping[str, float]
    of_effects: tuple[float, ...]
    grouped: Mapping[str, float]


def probabilities_of(diagnosis: Diagnosis, by: ProbabilityCriteria = PROBABILITY) -> Probabilities:
    """Probabilities of what the model lacks, by what a diagnosis has found; by: the weights."""
    named = [(_member(found.id), _named(diagnosis, found, by)) for found in diagnosis.effects]
    surest: dict[str, Answers] = {}  # an effect of several robots is one suspect
    for found, (member, answers) in zip(diagnosis.effects, named, strict=True):
        if found.id not in surest or answers[member] > surest[found.id][member]:
            surest[found.id] = answers
    questions = [*surest.values(), _of_the_rest(diagnosis, by)]
    names = [name for name in sorted(surest, key=lambda name: -surest[name][_member(name)]) if not is_law(name)]
    return Probabilities(
        told_sets(questions, by),
        tuple(answers[member] for member, answers in named),
        told_sets(questions, by, by_first_of(names)),
    )


def _named(diagnosis: Diagnosis, found: FoundEffect, by: ProbabilityCriteria) -> Answers:
    """Answers to whether a named effect is there, with what speaks against the whole diagnosis."""
    # Axes and units are put right before any fit: no effect is a rest of them.
    fitted = [each.id for each in diagnosis.effects if each.correction is None]
    answers = _of_effect(found, by, first=found.correction is not None or fitted[0] == found.id)
    differing = diagnosis.against is not None and bool(diagnosis.against.control)
    most = by.stopped if diagnosis.against is None else by.stopped_difference
    return _stopped(answers, most) if found.because or differing else answers


def _of_effect(found: FoundEffect, by: ProbabilityCriteria, *, first: bool) -> Answers:
    """Answers to whether a named effect is what it is named; first: it is the one with most evidence."""
    weights = {_member(found.id): 1.0}
    for rival in found.ambiguous_with:
        weights[rival.id] = weights.get(rival.id, 0.0) + math.exp(-by.temper * rival.nats_behind)
    weights[SOMETHING_ELSE] = weights.get(SOMETHING_ELSE, 0.0) + by.unnamed
    weights[NO_EFFECT] = _chance(found, by, first=first)
    return _scaled(weights)


def _chance(found: FoundEffect, by: ProbabilityCriteria, *, first: bool) -> float:
    """Weight of nothing in the place of a named effect."""
    if is_law(found.id):
        least = by.law if first else by.rest_by_law
    else:
        least = by.chance if first else by.rest
    beyond = found.nats - NAMING.threshold
    return least + math.exp(-by.temper * max(beyond, 0.0))


def _stopped(answers: Answers, most: float) -> Answers:
    """Take from what is named what exceeds `most`, in equal parts for what is not.

    A law outside the catalogue is named SOMETHING_ELSE; what is taken from it goes to NO_EFFECT.
    """
    has_name = not answers.keys() <= {NO_EFFECT, SOMETHING_ELSE}
    others = [NO_EFFECT, SOMETHING_ELSE] if has_name else [NO_EFFECT]
    named = sum(share for name, share in answers.items() if name not in others)
    kept = min(1.0, most / named)
    freed = (1.0 - kept) * named / len(others)
    return {name: share + freed if name in others else kept * share for name, share in answers.items()}


def _of_the_rest(diagnosis: Diagnosis, by: ProbabilityCriteria) -> Answers:
    """Answers to whether a diagnosis has passed something over; beside a name, nothing of it has one."""
    hidden = hidden_share(diagnosis.screened, by)
    without_name = any(each.stands for each in diagnosis.passed_over) or bool(diagnosis.beyond_floor)
    if without_name or (diagnosis.verdict == "mismatch" and not diagnosis.effects):
        return {SOMETHING_ELSE: by.stopped, NO_EFFECT: 1.0 - by.stopped}
    if diagnosis.effects:
        return _scaled({NO_EFFECT: 1.0, SOMETHING_ELSE: by.further * hidden})
    weights = {NO_EFFECT: 1.0, SOMETHING_ELSE: by.outside + by.missing * hidden}
    for each in diagnosis.screened:
        if each.nats > 0.0:
            weights[each.id] = math.exp(by.temper * (_nats_that_stand(each) - NAMING.threshold))
    return _scaled(weights)


def _nats_that_stand(each: ScreenedEffect) -> float:
    """Nats of an entry that was not named; one that promised enough was fitted, and they did not stand: none."""
    return each.nats if each.nats < NAMING.threshold else 0.0


def hidden_share(screened: Sequence[ScreenedEffect], by: ProbabilityCriteria = PROBABILITY) -> float:
    """Probability that an effect of the catalogue does not show, all entries and orders of size being as probable.

    Sizes go from `by.smallest` of a bad case to a bad case. 1 where nothing was screened.
    """
    if not screened:
        return 1.0
    below = (math.log(max(each.seen_from, by.smallest) / by.smallest) for each in screened)
    return sum(min(each / -math.log(by.smallest), 1.0) for each in below) / len(screened)


def _member(name: str) -> str:
    """Member of a set for what an identifier names: laws outside the catalogue have no name there."""
    return SOMETHING_ELSE if is_law(name) else name


def _scaled(weights: Mapping[str, float]) -> Answers:
    total = sum(weights.values())
    return {name: weight / total for name, weight in weights.items()}
