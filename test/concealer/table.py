"""The rows of the trial's table: rates of right and wrong answers with their intervals."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from concealer.cases import CATALOGUE_KINDS, Case
from concealer.figures import percent, rate
from concealer.six_degrees.makes import MAKES

Scores = dict[str, Any]
BY_THE_PRIOR = ("", "main", "families", *MAKES)  # parts of a trial in which nothing was asked for


def of_kind(cases: Iterable[Case], *kinds: str) -> list[Case]:
    """Cases of these classes."""
    return [case for case in cases if case.kind in kinds]


def medium(cases: Iterable[Case]) -> list[Case]:
    """Cases with one effect of medium size."""
    return [case for case in of_kind(cases, "single") if case.band == "medium"]


def grouped(cases: Iterable[Case], key: Callable[[Case], Any]) -> dict[str, Scores]:
    """Rate of exact answers by a key of the case."""
    groups: dict[str, list[bool]] = {}
    for case in cases:
        groups.setdefault(str(key(case)), []).append(case.exact())
    return {name: rate(answers) for name, answers in sorted(groups.items())}


def _naming(cases: list[Case]) -> Scores:
    rows: Scores = {}
    for noise in sorted({case.truth["noise"] for case in cases}):
        answers = [case.exact() for case in medium(cases) if case.truth["noise"] == noise]
        rows[f"exact, one medium effect, {percent(noise)} noise"] = rate(answers)
    single = of_kind(cases, "single")
    drawn = [case for case in single if case.block in BY_THE_PRIOR]
    named = [case for case in single if case.effects]
    hidden = of_kind(cases, *CATALOGUE_KINDS)
    several = [case for case in hidden if case.effects and len(case.truth.get("robots") or []) > 1]
    return rows | {
        "exact, one effect, all sizes": rate(case.exact() for case in drawn),
        "truth in ambiguity set, where something is named": rate(case.truth_in_set() for case in named),
        "first named effect wrong, one or more effects": rate(case.first_wrong() for case in hidden),
        "first named effect wrong, one medium effect": rate(case.first_wrong() for case in medium(cases)),
        "first named effect right but others added, one effect": rate(
            bool(case.effects and not case.first_wrong() and case.spurious()) for case in single
        ),
        "right robots, where several swim and something is named": rate(case.right_robots() for case in several),
        "names told as confirmed that are right, in all recordings": rate(_of_tier(cases, "confirmed")),
        "names told as suspected that are right, in all recordings": rate(_of_tier(cases, "suspected")),
    }


def _of_tier(cases: Iterable[Case], tier: str) -> list[bool]:
    return [is_right for case in cases for is_right in case.of_tier(tier)]


def _silence(cases: list[Case]) -> Scores:
    nothing, moved = of_kind(cases, "nothing"), of_kind(cases, "recalibration")
    return {
        "false alarm, nothing concealed": rate(case.false_alarm() for case in nothing),
        "false alarm, recalibration only": rate(case.false_alarm() for case in moved),
        "verdict consistent or recalibrate, nothing concealed": rate(
            case.verdict in ("consistent", "recalibrate") for case in nothing
        ),
        "verdict recalibrate, recalibration only": rate(case.verdict == "recalibrate" for case in moved),
    }


def _beyond(cases: list[Case]) -> Scores:
    several, outside, poor = (of_kind(cases, kind) for kind in ("several", "outside", "cannot_tell"))
    return {
        "exact, two effects": rate(case.exact() for case in several if len(case.hidden) == 2),
        "exact, three effects": rate(case.exact() for case in several if len(case.hidden) > 2),
        "nothing else named, two or three effects": rate(not case.spurious() for case in several),
        "outside the catalogue: flagged": rate(case.flagged() for case in outside),
        "outside the catalogue: right law": rate(case.rightly_unknown() for case in outside),
        "outside the catalogue: named as an entry of it": rate(case.named_wrongly() for case in outside),
        "cannot tell: abstains": rate(case.diagnosis is not None and not case.effects for case in poor),
        "cannot tell: abstains and says so": rate(case.says_so() for case in poor),
        "diagnosis written": rate(case.diagnosis is not None for case in cases),
    }


def table(cases: list[Case]) -> Scores:
    """The rows, and the mean size of the ambiguity set where one effect is hidden and something is named."""
    sets = [len(case.ambiguity_set()) for case in of_kind(cases, "single") if case.effects]
    rows = _naming(cases) | _silence(cases) | _beyond(cases)
    return {"rates": rows, "ambiguity_set_size": sum(sets) / len(sets) if sets else None}
