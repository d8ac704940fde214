"""Errors of one instrument for which readings speak as loudly as for that of another: neither has a name then.

Where a camera and a speed log disagree on lengths, only how far the vehicle comes tells which of them is wrong. If that
tells too little (`COMPARISON.instruments_apart`), one of two names would be right by chance.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.naming.detectability import name_of
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect


class Apart(NamedTuple):
    """Differences that keep their names, and names of errors that are one or the other: each with its rivals."""

    effects: tuple[FoundEffect, ...]
    either: tuple[tuple[str, ...], ...]


def apart(named: Sequence[NamedEffect], effects: Sequence[FoundEffect]) -> Apart:
    """Split off the errors of readings that may as well be errors of another stream's readings."""
    either = {(each.candidate.entry.id, each.candidate.entry.topic): _either(each) for each in named}
    undecided = [names for names in either.values() if len(names) > 1]
    left = tuple(each for each in effects if len(either.get((each.id, each.topic), ())) < 2)
    return Apart(left, tuple(undecided))


def of_either(names: Sequence[str]) -> str:
    """Sentence on errors of which one or the other differs."""
    return (
        f"{' or '.join(repr(name) for name in names)} differs: the readings speak as loudly for an error of the one "
        "instrument as for that of the other. These recordings cannot tell which it is; compare both with a third one."
    )


def _either(effect: NamedEffect) -> tuple[str, ...]:
    """Name an error of readings and its rivals among errors of other streams."""
    own = effect.candidate.entry
    if own.topic is None:
        return (own.id,)
    others = (rival.candidate.entry for rival in effect.rivals)
    rivals = (name_of(entry.id, entry.topic) for entry in others if entry.topic not in (None, own.topic))
    return tuple(dict.fromkeys((name_of(own.id, own.topic), *rivals)))
