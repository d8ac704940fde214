"""Order of refined candidates, and the rivals of the one that is named.

Whether anything differs from recordings that should be alike is told by what a candidate explains beyond the usual.
Which of several candidates it is, is told by the same readings for all: a delay of 0.1 s explains them no less because
alike recordings differ by some milliseconds, and a lag that never differs is no better for it. So candidates with
evidence enough are ranked by all that they explain, the usual included, and by what is beyond it only where the former
is as good as equal. Where nothing is compared, nothing is usual, and both orders are one. Of two that are as good as
equal, where one is the other with a number more, that number is not needed.
"""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.naming.choice import Choice
from cocorosim_ros.diagnosis.naming.contest import Refined
from cocorosim_ros.diagnosis.naming.instruments import is_beyond_instrument
from cocorosim_ros.diagnosis.naming.named_effect import NearRival, Stage
from cocorosim_ros.diagnosis.naming.natural_limits import is_at_its_limit
from cocorosim_ros.diagnosis.naming.needed_evidence import needed_nats, standing


def by_rank(refined: Sequence[Refined], stage: Stage) -> list[Refined]:
    """Order refined candidates, the one to be named first; those whose evidence is no more than usual are left out."""
    left = sorted((each for each in refined if not _is_usual(each, stage)), key=lambda each: -_explained(each))
    reached = [_behind(each, left[0], _explained(left[0]) - _explained(each)) <= NAMING.ambiguity for each in left]
    near = sorted(
        (each for each, reaches in zip(left, reached, strict=True) if reaches), key=lambda each: -standing(each)
    )
    far = [each for each, reaches in zip(left, reached, strict=True) if not reaches]
    return [*_simplest_first(near), *far]


def _simplest_first(near: Sequence[Refined]) -> list[Refined]:
    """Put what is as good as another with more numbers before it: an offset before a drift that begins with it."""
    order: list[Refined] = []
    for each in near:
        wider = (place for place, other in enumerate(order) if other.candidate.widens(each.candidate))
        order.insert(next(wider, len(order)), each)
    return order


def near_rivals(best: Refined, refined: Sequence[Refined], choice: Choice | None) -> list[NearRival]:
    """List entries of the catalogue that explain nearly as much as the best candidate, or more: its ambiguity set.

    Those that foretell clearly worse than it are none.
    """
    behind = [_behind(each, best, best.nats + best.usual - each.nats - each.usual) for each in refined]
    return [
        NearRival(other.candidate, max(0.0, nats))
        for other, nats in zip(refined, behind, strict=True)
        if other is not best
        and other.candidate.entry.law is None
        and nats <= (choice.reach(best, other.candidate) if choice is not None else NAMING.ambiguity)
        and not is_beyond_instrument(other.candidate, other.fit)
        and not is_at_its_limit(other.candidate, other.fit)
        and not (choice is not None and choice.excludes(best, other))
    ]


def _explained(refined: Refined) -> float:
    """Evidence of a candidate with what is usual among alike recordings [nats]."""
    return standing(refined) + refined.usual


def _behind(other: Refined, best: Refined, nats: float) -> float:
    """Nats between two candidates, which count for less where alike recordings differ in one of them."""
    return nats / max(other.candidate.spread, best.candidate.spread)


def _is_usual(refined: Refined, stage: Stage) -> bool:
    """Tell whether a candidate has too little evidence because recordings that should be alike differ in it as much."""
    return standing(refined) < needed_nats(stage.named, refined.candidate, refined.fit) <= _explained(refined)
