"""A marker off the origin, of which poses of one stream cannot tell, is told as the reason against what is named."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from named_in_vain import case_of

from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.showing.untold_lever import untold_lever
from cocorosim_ros.scenario.parts.platform import load_platform

AHEAD, LEFT = 0.03, -0.01
"""Where the marker sits [m]."""


def seen(swim: Callable[..., Any], *topics: str, ahead: float = AHEAD, left: float = LEFT) -> Evidence:
    """A swim as these streams show it, the marker of the camera off the origin."""
    evidence: Evidence = swim(load_platform("lily"), 120.0, seed=6)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    value, yaw = pose.value.copy(), pose.value[:, 3]
    value[:, 0] += ahead * np.cos(yaw) - left * np.sin(yaw)
    value[:, 1] += ahead * np.sin(yaw) + left * np.cos(yaw)
    streams = {topic: log.streams[topic] for topic in topics} | {"pose": replace(pose, value=value)}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def objections(evidence: Evidence, *, motion: bool = True) -> list[str]:
    """Sentences of the stop where an effect of no evidence is named: of motion, or of readings."""
    case = case_of(base_fit(evidence), "torque_bias" if motion else "pressure_offset")
    return [each.sentence for each in untold_lever(case)]


def test_a_marker_off_the_origin_is_told_with_its_place(swim: Callable[..., Any]) -> None:
    """To a millimetre, of a robot that a camera alone shows."""
    (sentence,) = objections(seen(swim))
    words = sentence.split()
    ahead, left = (float(words[words.index(each) - 2]) for each in ("before", "to"))
    assert ahead == pytest.approx(1e3 * AHEAD, abs=1.5)
    assert left == pytest.approx(-1e3 * LEFT, abs=1.5)
    assert "to the right of the body's origin" in sentence


def test_without_a_lever_or_where_it_is_looked_for_nothing_is_said(swim: Callable[..., Any]) -> None:
    """A marker at the origin; a robot with a compass, where levers have a name; errors of readings alone."""
    assert objections(seen(swim, ahead=0.0, left=0.0)) == []
    assert objections(seen(swim, "compass", "imu")) == []
    assert objections(seen(swim, "pressure"), motion=False) == []
