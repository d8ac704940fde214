"""The order in which effects are taken back where free runs with all of them are worse than without."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming import pruning
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming


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
