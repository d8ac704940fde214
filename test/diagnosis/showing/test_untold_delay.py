"""Commands that act later than they are logged are told as the reason against a lag that stands for them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from hidden_effects import hiding
from named_in_vain import case_of

from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.showing.untold_delay import untold_delay
from cocorosim_ros.scenario.parts.platform import load_platform

LATE = 0.2
"""By how much commands act late, or thrusters lag [s]."""


def sentences(evidence: Any) -> list[str]:
    """What is said against a lag that is fitted to the evidence and named."""
    case = case_of(base_fit(evidence), "thruster_lag")
    q = case.final.q.copy()
    q[-1] = 1.0  # from a lag and not from the edge at none
    final = settled(evaluated(replace(case.final, q=q)), 6)
    return [each.sentence for each in untold_delay(replace(case, final=final))]


def early(evidence: Any) -> Any:
    """The same evidence with all commands logged LATE seconds before they act."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    robots = (replace(log, command_time=log.command_time - LATE),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


def test_a_delay_of_commands_is_told_with_its_size(swim: Callable[..., Any]) -> None:
    """To two hundredths of a second, of a Lily whose commands are logged early; not of one whose thrusters lag."""
    lily = load_platform("lily")
    (told,) = sentences(early(swim(lily, 200.0, 3)))
    words = told.split()
    place = words.index("act")
    seconds = float(words[place + 1]) * {"s": 1.0, "ms": 1e-3}[words[place + 2]]
    assert seconds == pytest.approx(LATE, abs=0.02)
    assert "better than a lag does, by" in told
    lagging = hiding(lily, {"thruster_lag": {"time_constant": LATE}})
    assert sentences(swim(lagging, 200.0, 3, base=lily)) == []
