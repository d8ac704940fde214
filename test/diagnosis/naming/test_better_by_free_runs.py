"""Which effects may take the place of the one with most evidence because they foretell better."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming.choice import Choice
from cocorosim_ros.diagnosis.naming.contest import Refined

CLEAR, UNCLEAR = Gain(1.0, 0.1, 9), Gain(0.1, 0.2, 9)


def _refined(name: str, nats: float, law: object = None) -> Refined:
    candidate: Any = SimpleNamespace(entry=SimpleNamespace(id=name, law=law, channel="surge"))
    fit: Any = None
    return Refined(candidate, fit, nats)


def _choice(monkeypatch: pytest.MonkeyPatch, gains: dict[str, Gain]) -> Choice:
    """Make a choice in which each candidate gains over any leader what `gains` says."""
    monkeypatch.setattr(Choice, "_of", lambda self, refined: refined.candidate.entry.id)
    none: Any = None
    choice = Choice(none, none)
    choice.__dict__["_runs"] = SimpleNamespace(gain=lambda before, after: gains[after])
    return choice


@pytest.mark.parametrize(("nats", "taken"), [(49.0, True), (20.0, False)])
def test_a_stand_in_gives_way_to_what_explains_a_good_part_of_it(
    monkeypatch: pytest.MonkeyPatch, nats: float, taken: bool
) -> None:
    """A dead band of 49 nats takes the place of a linear drag of 321; an effect of 20 nats is none it stands for."""
    choice = _choice(monkeypatch, {"other": CLEAR})
    other = _refined("other", nats)
    assert choice.better(_refined("leader", 321.0), [other]) == ([other] if taken else [])


def test_the_clear_ones_come_in_the_order_of_their_gains(monkeypatch: pytest.MonkeyPatch) -> None:
    """One whose free runs are not clearly better is left out, however much evidence it has."""
    choice = _choice(monkeypatch, {"good": CLEAR, "best": Gain(np.e, 0.1, 9), "unclear": UNCLEAR})
    others = [_refined("good", 200.0), _refined("unclear", 300.0), _refined("best", 100.0)]
    assert [each.candidate.entry.id for each in choice.better(_refined("leader", 321.0), others)] == ["best", "good"]


def test_a_law_takes_no_entrys_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """A law outside the catalogue may take that of another law only."""
    choice = _choice(monkeypatch, {"law": CLEAR})
    law = _refined("law", 300.0, law="surge~u")
    assert choice.better(_refined("leader", 321.0), [law]) == []
    assert choice.better(_refined("leading law", 321.0, law="surge~v"), [law]) == [law]
