"""Sets of suspects and their probabilities, from answers to independent questions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from cocorosim_ros.diagnosis.criteria.probability import ProbabilityCriteria

NO_EFFECT, SOMETHING_ELSE = "nothing", "something else"
AND_MORE = "more"
"""Member that stands for all others in sets that are told by one of their members alone."""
TOGETHER = " + "

Missing = frozenset[str]
"""Set of what the model lacks: identifiers of the catalogue, and SOMETHING_ELSE; empty for nothing."""
Answers = Mapping[str, float]
"""Probabilities of the answers to one question: identifiers, SOMETHING_ELSE, NO_EFFECT; in all 1."""


Place = Callable[[Missing], Missing]
"""Function of a set that is not kept: the set to whose probability its own is added."""
_UNNAMED: Missing = frozenset({SOMETHING_ELSE})


def unnamed(missing: Missing) -> Missing:
    """SOMETHING_ELSE alone, whatever the set holds."""
    return _UNNAMED


def by_first_of(names: Sequence[str]) -> Place:
    """Make a function of a set: the first of some names that it holds, and more; SOMETHING_ELSE if it holds none."""

    def place(missing: Missing) -> Missing:
        first = next((name for name in names if name in missing), None)
        return _UNNAMED if first is None else frozenset({first, AND_MORE})

    return place


def told_sets(questions: Sequence[Answers], by: ProbabilityCriteria, place: Place = unnamed) -> dict[str, float]:
    """The most probable sets that the answers to some questions make together, by their names; in all 1.

    place: what becomes of the sets that are not told.
    """
    joint: dict[Missing, float] = {frozenset(): 1.0}
    for answers in questions:
        joint = _joined(joint, answers, by, place)
    whole = (each for each in joint if joint[each] >= by.least_told and AND_MORE not in each)
    chosen = _with_the_rest_placed(joint, sorted(whole, key=lambda each: -joint[each])[: by.most_told], place)
    return {_name(each): chosen[each] for each in sorted(chosen, key=lambda each: -chosen[each])}


def _joined(
    joint: Mapping[Missing, float], answers: Answers, by: ProbabilityCriteria, place: Place
) -> dict[Missing, float]:
    """Put one more question to all sets; of very many, the least probable ones are placed with others."""
    found: dict[Missing, float] = {}
    for missing, share in joint.items():
        for name, probability in answers.items():
            more = missing if name == NO_EFFECT else missing | {name}
            found[more] = found.get(more, 0.0) + share * probability
    order = sorted(found, key=lambda missing: -found[missing])
    return _with_the_rest_placed(found, order[: by.most_sets], place)


def _with_the_rest_placed(
    joint: Mapping[Missing, float], kept: Sequence[Missing], place: Place
) -> dict[Missing, float]:
    """Keep some sets, the empty one, and that of SOMETHING_ELSE alone; all others are added where they are placed."""
    kept = (*kept, frozenset(), _UNNAMED)
    chosen = {each: joint.get(each, 0.0) for each in kept}
    placed: dict[Missing, list[float]] = {}
    for missing, share in joint.items():
        if missing not in chosen:
            placed.setdefault(place(missing), []).append(share)
    return chosen | {missing: chosen.get(missing, 0.0) + sum(shares) for missing, shares in placed.items()}


def _name(missing: Missing) -> str:
    """Name of a set: identifiers by the alphabet, SOMETHING_ELSE or AND_MORE last."""
    last = missing & {SOMETHING_ELSE, AND_MORE}
    return TOGETHER.join([*sorted(missing - last), *sorted(last)]) or NO_EFFECT
