"""Whether what is told as probable comes true as often: reliability by class of probability, and Brier's score.

A diagnosis tells a probability of each of some sets of suspects, of "something else" and of "nothing". One of these
comes true. Sources: Brier, Monthly Weather Review 78 (1950) 1 (score); Murphy, J. Applied Meteorology 12 (1973) 595
(its parts).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import permutations
from typing import Any

import numpy as np

from concealer.cases import Case, names
from concealer.figures import Z95, rate

Scores = dict[str, Any]
NOTHING, SOMETHING_ELSE, TOGETHER = "nothing", "something else", " + "
EDGES = (0.0, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 1.0)


def told(case: Case) -> dict[str, float]:
    """Probabilities of a diagnosis; none where there is no diagnosis, or an older one."""
    return dict((case.diagnosis or {}).get("probabilities") or {})


def came_true(case: Case) -> str:
    """Which of the told answers is right: the set of what is hidden, or the nearest that something else completes.

    "A + something else" is right where A is hidden and anything beside it, if no told set is just that.
    """
    if not case.hidden:
        return NOTHING
    sets = [name for name in told(case) if name not in (NOTHING, SOMETHING_ELSE)]
    exact = [name for name in sets if SOMETHING_ELSE not in name.split(TOGETHER) and _left(name, case) == 0]
    partly = [name for name in sets if SOMETHING_ELSE in name.split(TOGETHER) and _left(name, case) > 0]
    return next(iter([*exact, *sorted(partly, key=lambda name: _left(name, case))]), SOMETHING_ELSE)


def _left(name: str, case: Case) -> int:
    """How many secrets the named members of a set leave over; -1 if one of these members stands for none of its own."""
    members, hidden = [each for each in name.split(TOGETHER) if each != SOMETHING_ELSE], case.truth["effects"]
    each_has_one = any(
        all(member in {truth["id"], *truth.get("twins", [])} for member, truth in zip(members, order, strict=False))
        for order in permutations(hidden, len(members))
    )
    return len(hidden) - len(members) if each_has_one else -1


def brier(probabilities: dict[str, float], right: str) -> float:
    """Sum over all answers of the square of the probability less 1 for the right one, 0 for others: from 0 to 2."""
    return sum((share - (name == right)) ** 2 for name, share in probabilities.items())


def parts_of_brier(forecast: Sequence[float], happened: Sequence[bool]) -> Scores:
    """Brier's score of one kind of event and Murphy's parts of it: score = reliability - resolution + uncertainty.

    Within a class all forecasts count as their mean in the parts, so that the sum is exact only for equal ones.
    uncertainty: also the score of a forecast that is always the rate of the event.
    """
    p, o = np.asarray(forecast, dtype=float), np.asarray(happened, dtype=float)
    chosen = [np.flatnonzero(classes(p) == number) for number in range(len(EDGES) - 1)]
    groups = [group for group in chosen if len(group)]
    reliability = sum(len(group) * (p[group].mean() - o[group].mean()) ** 2 for group in groups) / len(p)
    resolution = sum(len(group) * (o[group].mean() - o.mean()) ** 2 for group in groups) / len(p)
    return {
        "score": float(np.mean((p - o) ** 2)), "reliability": float(reliability), "resolution": float(resolution),
        "uncertainty": float(o.mean() * (1.0 - o.mean())), "of": len(p),
    }  # fmt: skip


def classes(forecast: np.ndarray) -> np.ndarray:
    """(n,) numbers of the classes of EDGES that probabilities (n,) fall into; an edge belongs to the class above."""
    return np.clip(np.searchsorted(EDGES, forecast, side="right") - 1, 0, len(EDGES) - 2)


def reliability(pairs: Sequence[tuple[float, bool]]) -> list[Scores]:
    """For each class of told probabilities: their mean, and how often what was told came true."""
    if not pairs:
        return []
    number = classes(np.array([share for share, _ in pairs]))
    rows = []
    for place in sorted(set(number.tolist())):
        mine = [pair for pair, own in zip(pairs, number.tolist(), strict=True) if own == place]
        mean = sum(share for share, _ in mine) / len(mine)
        rows.append({"from": EDGES[place], "to": EDGES[place + 1], "mean": mean} | rate(true for _, true in mine))
    return rows


def calibration(cases: Iterable[Case]) -> Scores:
    """All figures about the probabilities of the diagnoses that tell any; empty if none does."""
    some = [case for case in cases if told(case)]
    if not some:
        return {}
    answers = [(told(case), came_true(case)) for case in some]
    best = [(max(shares, key=lambda name: shares[name]), right, shares) for shares, right in answers]
    return {
        "recordings": len(some),
        "brier": _mean([brier(shares, right) for shares, right in answers]),
        "brier_of_certainty": _mean([2.0 * (name != right) for name, right, _ in best]),
        "most_probable": parts_of_brier([shares[name] for name, _, shares in best], [n == r for n, r, _ in best]),
        "by_most_probable": reliability([(shares[name], name == right) for name, right, shares in best]),
        "by_any": reliability([(share, name == right) for shares, right in answers for name, share in shares.items()]),
        "by_effect": reliability([pair for case in some for pair in _effects(case)]),
        "by_answer": _by_answer(answers),
    }


def _effects(case: Case) -> list[tuple[float, bool]]:
    """Probability of each named effect by itself, each once, and whether it is hidden."""
    once = {effect["id"]: effect for effect in reversed(case.effects)}
    return [(float(effect["probability"]), _is_hidden(effect, case)) for effect in once.values()]


def _is_hidden(effect: dict[str, Any], case: Case) -> bool:
    """Whether a named effect is hidden; of a law outside the catalogue, whether any such law is."""
    if str(effect["id"]).startswith("unknown:"):
        return any(name.startswith("unknown:") for name in case.hidden)
    return any(names(effect, truth) for truth in case.truth["effects"])


def _by_answer(answers: Sequence[tuple[dict[str, float], str]]) -> Scores:
    """Mean of what is told of an answer, and how often it comes true."""
    pairs: dict[str, list[tuple[float, bool]]] = {}
    for shares, right in answers:
        for name, share in shares.items():
            kind = name if name in (NOTHING, SOMETHING_ELSE) else "effects by name"
            pairs.setdefault(kind, []).append((share, name == right))
    return {
        kind: {"mean": sum(share for share, _ in found) / len(found)} | rate(true for _, true in found)
        for kind, found in sorted(pairs.items())
    }


def _mean(values: Sequence[float]) -> Scores:
    """Mean with its 95 % interval by the normal distribution; none of a single value."""
    mean = sum(values) / len(values)
    half = Z95 * float(np.std(values, ddof=1)) / math.sqrt(len(values)) if len(values) > 1 else math.inf
    low, high = (mean - half, mean + half) if math.isfinite(half) else (None, None)
    return {"mean": mean, "low": low, "high": high, "of": len(values)}
