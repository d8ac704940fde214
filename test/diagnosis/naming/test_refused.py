"""A candidate with evidence enough that free runs are against is kept in mind, not forgotten."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming import naming, ranking
from cocorosim_ros.diagnosis.naming.contest import Refined


@pytest.mark.parametrize("refuses", [True, False])
def test_what_free_runs_refuse_is_noted(monkeypatch: pytest.MonkeyPatch, refuses: bool) -> None:
    """It is not named and stands among the refused; one that they do not refuse is named and does not."""
    monkeypatch.setattr(naming, "_held_out_if_nameable", lambda *_: HeldOutGain(np.ones(3), 0.01))
    entry = SimpleNamespace(id="thruster_gain:left", law=None, channel="yaw", topic=None)
    candidate: Any = SimpleNamespace(entry=entry, spread=1.0, key=("thruster_gain:left", None, ("a",)))
    stage: Any = SimpleNamespace(named=(), fit=None)
    fit: Any = SimpleNamespace(unknowns=())
    choice: Any = SimpleNamespace(
        better=lambda leader, others: [],
        gain=lambda best: Gain(-0.1 if refuses else 0.5, 0.1, 9),
        refuses=lambda best, gain: refuses,
        refused=[],
    )
    found = naming._first_believed(stage, [Refined(candidate, fit, 50.0)], naming.PassedOver([], [], []), choice)
    kept = [each.effect.candidate for each in choice.refused]
    assert (found is None, kept) == ((True, [candidate]) if refuses else (False, []))


@pytest.mark.parametrize(("nats", "rivals"), [(150.0, ["advance_loss"]), (6.0, [])])
def test_what_explains_more_but_may_be_a_rest_is_a_rival(
    monkeypatch: pytest.MonkeyPatch, nats: float, rivals: list[str]
) -> None:
    """A loss of thrust that the file's own drag may have left over, ahead of the drag that is named in its place.

    Of less than a name needs it is none.
    """

    def candidate(name: str) -> Any:
        entry = SimpleNamespace(id=name, law=None, channel="surge", topic=None, amplitudes=())
        return SimpleNamespace(
            entry=entry, spread=1.0, key=(name, None, ("a",)), robots=("a",), widens=lambda other: False
        )

    fit: Any = SimpleNamespace(unknowns=())
    loss, drag = Refined(candidate("advance_loss"), fit, nats), Refined(candidate("anisotropic_drag"), fit, 70.0)
    begun: Any = [SimpleNamespace(candidate=each.candidate, gain=each.nats) for each in (loss, drag)]
    needed = {"advance_loss": 190.0, "anisotropic_drag": 8.0}
    monkeypatch.setattr(naming, "_worth_refining", lambda tested: [])
    monkeypatch.setattr(naming, "_begun", lambda *_: begun)
    monkeypatch.setattr(naming, "_by_promise", lambda *_: (begun[:1], begun[1:]))
    monkeypatch.setattr(naming, "log_evidence", lambda fit: 0.0)
    monkeypatch.setattr(naming, "_refined", lambda fit, each, base: loss if each is begun[0] else drag)
    monkeypatch.setattr(naming, "by_rank", lambda refined, stage: list(refined))
    monkeypatch.setattr(naming, "needed_nats", lambda named, each, fit: needed[each.entry.id])
    monkeypatch.setattr(naming, "_held_out_if_nameable", lambda *_: HeldOutGain(np.ones(3), 0.01))
    for limit in ("is_beyond_instrument", "is_at_its_limit"):
        monkeypatch.setattr(ranking, limit, lambda *_: False)
    screen: Any = SimpleNamespace(fit=fit, scene=None)
    found = naming._best_by_slopes((), screen, (), (), None)
    assert found is not None and found[1].candidate is drag.candidate
    assert [each.candidate.entry.id for each in found[1].rivals] == rivals
