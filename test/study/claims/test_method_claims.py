"""M1 to M3: what they say follows from the results."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.study.claims import method_claims
from cocorosim_ros.study.claims.method_claims import crowd_scenario, method_answers


@pytest.mark.parametrize(("seconds", "verdict"), [(3.0, "reproduced"), (1.5, "not reproduced")])
def test_the_bottleneck(
    made_up: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, seconds: float, verdict: str
) -> None:
    """Currents are the bottleneck when they cost more than all the rest: ticks that take more than twice as long."""
    monkeypatch.setattr(method_claims, "crowd_speed", lambda: 0.5)
    results = {
        "boids": made_up("boids", ("Van", "BLT"), {("BLT", "wall_seconds"): 1.0}),
        "turbulence": made_up("turbulence", ("T0", "T5e-4"), {("T5e-4", "wall_seconds"): seconds}),
    }
    answers = {answer.claim: answer for answer in method_answers(results)}
    assert answers["M2"].verdict == verdict
    assert "wall time" in answers["M2"].subject and "processor" not in answers["M2"].subject
    assert answers["M3"].verdict == "not reproduced" and "0.5 times" in answers["M3"].ours


@pytest.mark.parametrize(
    ("there", "asked", "verdict", "words"),
    [
        (400, 400, "reproduced", "400 runs: 0.53"),  # facts 2.5: the largest of 19 has the median 0.537
        (400, 100, "not reproduced", "400 runs: 0.53"),
        (40, 400, "not decidable", "10 runs: 0.7"),
        (0, 400, "no runs", "\u2013"),
    ],
)
def test_enough_runs(
    made_up: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, there: int, asked: int, verdict: str, words: str
) -> None:
    """M1 follows from the runs of each baseline: all metrics of these runs go together, so that six are as one."""
    monkeypatch.setattr(method_claims, "crowd_speed", lambda: 0.5)
    monkeypatch.setattr(method_claims, "RUNS", asked)
    results = {
        design: made_up(design, (group,), {}, there) for design, group in (("boids", "Van"), ("turbulence", "T0"))
    }
    found = [answer for answer in method_answers(results) if answer.claim == "M1"]
    assert [answer.subject.partition(":")[0] for answer in found] == ["Van", "T0"]
    assert {answer.verdict for answer in found} == {verdict}
    assert all(answer.ours.startswith(words) for answer in found)


def test_the_crowd_is_as_dense() -> None:
    """A thousand robots in 6 m * 6 m * 1000 / 11, 2 m deep."""
    scenario = crowd_scenario()
    assert len(scenario.robots) == 1000
    assert math.prod(scenario.tank.size) == pytest.approx(72.0 * 1000 / 11)
