"""The end of a candidate's fit: turns of noise and numbers, while each gains enough."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.criteria.naming import SEARCH
from cocorosim_ros.diagnosis.naming import contest
from cocorosim_ros.diagnosis.naming.contest import Begun, refine

ENOUGH = 2.0 * SEARCH.last_steps


@pytest.mark.parametrize(
    ("gains", "turns"),
    [([0.5], 1), ([ENOUGH, 0.5], 2), ([ENOUGH, ENOUGH, ENOUGH, 0.5], 4), ([ENOUGH] * 100, 1 + SEARCH.most_turns)],
    ids=["at once", "one more", "as long as it gains", "no longer than that"],
)
def test_a_fit_goes_on_while_it_gains(monkeypatch: pytest.MonkeyPatch, gains: list[float], turns: int) -> None:
    """A large current gains in each of ten turns: cut off after the second, a form with more numbers seemed better."""
    taken: list[float] = []

    def climb(fit: Any, rounds: int) -> Any:
        taken.append(gains[len(taken)])
        return SimpleNamespace(objective=fit.objective + taken[-1])

    monkeypatch.setattr(contest, "with_noise", lambda fit, rounds, which: fit)
    monkeypatch.setattr(contest, "improved", climb)
    monkeypatch.setattr(contest, "log_evidence", lambda fit: fit.objective)
    candidate: Any = SimpleNamespace(entry=SimpleNamespace(topic=None))
    begun: Any = Begun(candidate, SimpleNamespace(objective=100.0), 0.0)
    assert refine(begun, 0.0).nats == pytest.approx(100.0 + sum(gains[:turns]))
    assert len(taken) == turns
