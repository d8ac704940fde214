"""A log that is turned against the hull, which no other reading tells, is told with its angle."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from named_in_vain import case_of

from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.showing.case import Case
from cocorosim_ros.diagnosis.showing.untold_turn import untold_turn
from cocorosim_ros.scenario.parts.platform import load_platform

ANGLE = 0.12
"""By which the log is turned to the left [rad]."""


def seen(swim_with_logs: Callable[..., Any], *topics: str, angle: float = ANGLE) -> Evidence:
    """A swim as these streams show it, and a log of the speed over ground that is turned."""
    evidence: Evidence = swim_with_logs(load_platform("lily"), 120.0, 6)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    speeds = log.streams["ground_velocity"]
    value, (ahead, left) = speeds.value.copy(), speeds.value[:, :2].T
    value[:, 0] = ahead * math.cos(angle) + left * math.sin(angle)
    value[:, 1] = left * math.cos(angle) - ahead * math.sin(angle)
    streams = {topic: log.streams[topic] for topic in topics} | {"ground_velocity": replace(speeds, value=value)}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def sentences(evidence: Evidence, effect: str = "") -> list[str]:
    """Sentences of the stop where an effect of no evidence is named, or none at all."""
    base = base_fit(evidence)
    case = case_of(base, effect) if effect else Case(base, (), (), smoothed_tracks(base), {}, base)
    return [each.sentence for each in untold_turn(case)]


@pytest.mark.parametrize("effect", ["", "torque_bias"])
def test_a_turned_log_is_told_with_its_angle(swim_with_logs: Callable[..., Any], effect: str) -> None:
    """Within a degree, whether anything is named or not."""
    (sentence,) = sentences(seen(swim_with_logs, "compass", "imu", "pressure"), effect)
    assert ("all that is named" in sentence) == bool(effect)
    words = sentence.split()
    assert words[words.index("to") + 2] == "left"
    degrees = float(words[words.index("by") + 1].removesuffix("°"))
    assert degrees == pytest.approx(np.degrees(ANGLE), abs=1.0)


def test_of_a_straight_log_or_one_that_is_looked_for_nothing_is_said(swim_with_logs: Callable[..., Any]) -> None:
    """A log along the hull; one beside poses, where its angle has a name."""
    assert sentences(seen(swim_with_logs, "compass", "imu", "pressure", angle=0.0)) == []
    assert sentences(seen(swim_with_logs, "pose", "compass", "imu")) == []
