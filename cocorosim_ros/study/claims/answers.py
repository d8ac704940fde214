"""One answer: what the paper claims, what was found in one kind of numerics, and whether the two agree."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

REPRODUCED, NOT_REPRODUCED, NOT_DECIDABLE, NO_RUNS = "reproduced", "not reproduced", "not decidable", "no runs"
MARKS = {REPRODUCED: "yes", NOT_REPRODUCED: "**no**", NOT_DECIDABLE: "open", NO_RUNS: "no runs"}
"""Verdicts as a table has them."""
DASH = "\u2013"
"""What stands where nothing could be found."""


@dataclass(frozen=True)
class Answer:
    """A claim in one kind of numerics, in words."""

    claim: str
    """Its short name, such as S4."""
    subject: str
    """What is compared with what."""
    paper: str
    numerics: str
    ours: str
    verdict: str


def above(border: float, low: float, high: float) -> str:
    """The verdict on a number that is claimed to be above a border, by its interval; not decidable without one."""
    if low > border:
        return REPRODUCED
    return NOT_REPRODUCED if high < border else NOT_DECIDABLE


def denied(verdict: str) -> str:
    """The verdict on the contrary of a claim."""
    return {REPRODUCED: NOT_REPRODUCED, NOT_REPRODUCED: REPRODUCED}.get(verdict, verdict)


def all_of(verdicts: Iterable[str]) -> str:
    """The verdict on a claim that holds when all its parts hold."""
    parts = list(verdicts)
    for verdict in (NO_RUNS, NOT_REPRODUCED, NOT_DECIDABLE):
        if verdict in parts:
            return verdict
    return REPRODUCED if parts else NO_RUNS
