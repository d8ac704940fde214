"""Sets of suspects and their probabilities, from answers to independent questions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.criteria.probability import ProbabilityCriteria

NO_EFFECT, SOMETHING_ELSE = "nothing", "something else"
TOGETHER = " + "

Missing = frozenset[str]
"""Set of what the model lacks: identifiers of the catalogue, and SOMETHING_ELSE; empty for nothing."""
Answers = Mapping[str, float]
"""Probabilities of the answers to one question: identifiers, SOMETHING_ELSE, NO_EFFECT; in all 1."""


def all_sets(questions: Sequence[Answers], by: ProbabilityCriteria) -> dict[Missing, float]:
    """Probability of each set that the answers to some questions make together, in all 1."""
    joint: dict[Missing, float] = {frozenset(): 1.0}
    for answers in questions:
        joint = _joined(joint, answers, by)
    return joint


def told_sets(joint: Mapping[Missing, float], by: ProbabilityCriteria) -> dict[str, float]:
    """The most probable sets by the names under which they are told."""
    likely = sorted((each for each in joint if joint[each] >= by.least_told), key=lambda each: -joint[each])
    chosen = _with_the_rest_unnamed(joint, likely[: by.most_told])
    return {_name(each): chosen[each] for each in sorted(chosen, key=lambda each: -chosen[each])}


def _joined(joint: Mapping[Missing, float], answers: Answers, by: ProbabilityCriteria) -> dict[Missing, float]:
    """Put one more question to all sets; of very many, the least probable ones become SOMETHING_ELSE."""
    found: dict[Missing, float] = {}
    for missing, share in joint.items():
        for name, probability in answers.items():
            more = missing if name == NO_EFFECT else missing | {name}
            found[more] = found.get(more, 0.0) + share * probability
    order = sorted(found, key=lambda missing: -found[missing])
    return _with_the_rest_unnamed(found, order[: by.most_sets])


def _with_the_rest_unnamed(joint: Mapping[Missing, float], kept: Sequence[Missing]) -> dict[Missing, float]:
    """Keep some sets, the empty one, and that of SOMETHING_ELSE alone, to which all others are added."""
    unnamed, empty = frozenset({SOMETHING_ELSE}), frozenset[str]()
    chosen = {each: joint.get(each, 0.0) for each in (*kept, empty, unnamed)}
    chosen[unnamed] += sum(share for missing, share in joint.items() if missing not in chosen)
    return chosen


def _name(missing: Missing) -> str:
    """Name of a set: identifiers by the alphabet, SOMETHING_ELSE last."""
    named = sorted(missing - {SOMETHING_ELSE})
    return TOGETHER.join([*named, SOMETHING_ELSE] if SOMETHING_ELSE in missing else named) or NO_EFFECT
