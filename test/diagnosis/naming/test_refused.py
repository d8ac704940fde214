"""A candidate with evidence enough that free runs are against is kept in mind, not forgotten."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming import naming
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
    found = naming._first_believed(stage, [Refined(candidate, fit, 50.0)], naming.PassedOver([], []), choice)
    kept = [each.effect.candidate for each in choice.refused]
    assert (found is None, kept) == ((True, [candidate]) if refuses else (False, []))
