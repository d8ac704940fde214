"""Sentences on differences that readings speak for, but that get no name: the recordings cannot tell."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.naming.detectability import name_of
from cocorosim_ros.diagnosis.naming.named_effect import Naming

REFUSED = (
    "'{name}' may differ: the readings speak for it, but free runs through data that no fit saw gain nothing by it. "
    "These recordings cannot tell."
)
VAGUE = (
    "'{name}' most likely differs, but its size differs from part to part of the recordings, or is badly known, and "
    "may as well be nothing. These recordings cannot tell."
)
TRACE = (
    "'{name}' may differ, but free runs speak against a motion for which the readings speak as loudly, and this may be "
    "its trace. These recordings cannot tell."
)


def names_of(naming: Naming, candidates: Sequence[Candidate]) -> tuple[str, ...]:
    """Names of candidates that were passed over, and are not named after all."""
    named = {each.candidate.entry.id for each in naming.named}
    found = (each.entry for each in candidates if each.entry.law is None and each.entry.id not in named)
    return tuple(dict.fromkeys(name_of(entry.id, entry.topic) for entry in found))


def doubts(sentence: str, names: Sequence[str]) -> tuple[str, ...]:
    """One of the sentences of this module for each of some differences."""
    return tuple(sentence.format(name=name) for name in names)


def of_unsettled(names: Sequence[str]) -> tuple[str, ...]:
    """Sentence on what could be named, the first of some names, and on what it may stand in for."""
    if not names:
        return ()
    first, *others = names
    return (
        f"'{first}' may differ, or stand in for {' or '.join(repr(each) for each in others)}: the readings speak "
        "louder for that, but the recordings of --against differ in it among themselves. These recordings cannot tell.",
    )
