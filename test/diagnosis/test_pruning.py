"""The order in which effects are taken back where free runs with all of them are worse than without."""

from __future__ import annotations

from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming import pruning
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming


@dataclass(frozen=True)
class Model:
    """Unknowns of a fit, and its evidence."""

    unknowns: tuple[Unknown, ...]
    evidence: float


def effect(name: str, nats: float, mean: float | None) -> NamedEffect:
    """An effect with this evidence, by which free runs gain so much on the average; None for an error of readings."""
    candidate: Any = SimpleNamespace(key=(name, None, ("a",)))
    told = None if mean is None else Gain(mean, 0.1, 8)
    return NamedEffect(candidate, nats, (), HeldOutGain(np.zeros(1), 1.0), told)


def test_what_speaks_least_for_itself_goes_first(monkeypatch: pytest.MonkeyPatch) -> None:
    """Losses, the greatest first; then errors of readings, the weakest first; gains last, however few their nats."""
    monkeypatch.setattr(pruning, "without", lambda fit, candidate, base: (*fit, candidate.key[0]))
    named = (
        effect("gains_much", 9.0, 0.8),
        effect("loses", 900.0, -0.1),
        effect("late", 50.0, None),
        effect("loses_more", 90.0, -0.2),
        effect("later", 70.0, None),
        effect("gains_little", 500.0, 0.1),
    )
    fit: Any = ()
    naming = Naming(fit, fit, named, (), ())
    while naming.named:
        naming = pruning.without_least(naming)
    taken: Any = naming.fit
    assert taken == ("loses_more", "loses", "late", "later", "gains_little", "gains_much")


def test_an_effect_is_taken_back_from_some_robots(monkeypatch: pytest.MonkeyPatch) -> None:
    """It stays for the others with the rest of its nats, and owns its own amplitudes and what all had in common."""
    entry = next(each for each in ENTRIES if each.shapes and not each.water and each.topic is None)
    whole = Candidate(entry, ("a", "b", "c"), ((0, 2), (1,), (3,)))
    amplitudes = whole.amplitudes()
    shape = replace(amplitudes[0], owner=Owner(entry.id, whole.robots, "place", "m"), tracks=whole.everybody)
    fit: Any = Model((*amplitudes, shape), 50.0)

    def without(before: Any, gone: Candidate, base: Any) -> Any:
        return Model(tuple(each for each in before.unknowns if not gone.owns(each)), 38.0)

    monkeypatch.setattr(pruning, "without", without)
    monkeypatch.setattr(pruning, "log_evidence", lambda each: each.evidence)
    monkeypatch.setattr(pruning, "held_against", lambda candidate, less, more: 2.0)
    named = NamedEffect(whole, 30.0, (), HeldOutGain(np.zeros(1), 1.0))
    naming, gone = pruning.taken_back(Naming(fit, fit, (named,), (), ()), named, ("b",))
    (left,) = naming.named
    assert (gone.candidate.robots, gone.candidate.tracks, gone.nats) == (("b",), ((1,),), 50.0 - 38.0 - 2.0)
    assert (left.candidate.robots, left.candidate.tracks, left.nats) == (("a", "c"), ((0, 2), (3,)), 30.0 - 10.0)
    assert all(left.candidate.owns(each) for each in naming.fit.unknowns)
    assert [each.tracks for each in naming.fit.unknowns][-1] == (0, 2, 3)
    naming, gone = pruning.taken_back(naming, left, ("a", "c"))
    assert naming.named == () and naming.fit.unknowns == ()
