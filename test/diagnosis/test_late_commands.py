"""Commands that act later than they are logged have a name, and a lag of the thrusters keeps its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.scenario.parts.platform import load_platform

LATE = 0.2
"""By how much commands act late, or thrusters lag [s]."""


def with_log(evidence: Any, **changes: Any) -> Any:
    """The evidence, of one robot, with changes of its log."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, **changes),)),))


def early(evidence: Any) -> Any:
    """The same evidence with all commands logged LATE seconds before they act."""
    return with_log(evidence, command_time=evidence.recordings[0].robots[0].command_time - LATE)


def bent_by_iron(evidence: Any) -> Any:
    """The same evidence with a compass that iron turns by 0.04 sin(2 yaw) - 0.03 cos(2 yaw)."""
    streams = evidence.recordings[0].robots[0].streams
    compass, yaw = streams["compass"], streams["compass"].value
    bent = replace(compass, value=yaw + 0.04 * np.sin(2.0 * yaw) - 0.03 * np.cos(2.0 * yaw))
    return with_log(evidence, streams={**streams, "compass": bent})


def found(evidence: Any) -> dict[str, dict[str, Any]]:
    """Numbers of the effects that a diagnosis names, by effect and name."""
    diagnosis = diagnose(evidence, lambda _words, _share: None)
    return {each.id: dict(each.parameters) for each in diagnosis.effects}


def test_commands_that_are_logged_early(swim: Any) -> None:
    """They act late by that much, to a hundredth of a second."""
    (name, numbers), *others = found(early(swim(load_platform("lily"), 200.0, 3))).items()
    assert (name, others) == ("command_delay", [])
    assert numbers["delay"].low <= LATE <= numbers["delay"].high
    assert numbers["delay"].value == pytest.approx(LATE, abs=0.01)


def test_a_lag_is_no_delay(swim: Any) -> None:
    """A lag of the thrusters by as much is a lag."""
    lily = load_platform("lily")
    lagging = swim(hiding(lily, {"thruster_lag": {"time_constant": LATE}}), 200.0, 3, base=lily)
    assert list(found(lagging)) == ["thruster_lag"]


def test_soft_iron_beside_the_compass(swim: Any) -> None:
    """Its numbers are those of the deviation, within their intervals."""
    (name, numbers), *others = found(bent_by_iron(swim(load_platform("lily"), 200.0, 3))).items()
    assert (name, others) == ("soft_iron", [])
    for number, truth in (("sin_2", 0.04), ("cos_2", -0.03)):
        assert numbers[number].low <= truth <= numbers[number].high
