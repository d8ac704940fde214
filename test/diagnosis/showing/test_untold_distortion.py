"""A distorted compass beside places alone, which nothing else tells, is told as the reason against what is named."""

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
from cocorosim_ros.diagnosis.showing.untold_distortion import untold_distortion
from cocorosim_ros.scenario.parts.platform import load_platform

SINE, COSINE = 0.12, -0.09
"""Of the distortion [rad]: 0.15 together."""


def seen(swim: Callable[..., Any], *, sine: float = SINE, cosine: float = COSINE, with_yaw: bool = False) -> Evidence:
    """A swim as a tracker of places, perhaps with the yaw, and a compass beside iron show it."""
    evidence: Evidence = swim(load_platform("lily"), 120.0, seed=6)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose, compass = log.streams["pose"], log.streams["compass"]
    places, noise = pose.value.copy(), pose.noise.copy()
    if not with_yaw:
        places[:, 3] = noise[3] = np.nan
    heading = np.interp(compass.time, pose.time, pose.value[:, 3])[:, None]
    shown = compass.value + sine * np.sin(heading) + cosine * np.cos(heading)
    streams = {"pose": replace(pose, value=places, noise=noise), "compass": replace(compass, value=shown)}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def objections(evidence: Evidence, effect: str = "steady_current") -> list[str]:
    """Sentences of the stop where an effect of no evidence is named."""
    return [each.sentence for each in untold_distortion(case_of(base_fit(evidence), effect))]


def test_a_compass_beside_iron_is_told_with_its_size(swim: Callable[..., Any]) -> None:
    """Within a degree, where a current is named."""
    (sentence,) = objections(seen(swim))
    words = sentence.split()
    degrees = float(words[words.index("up") + 2].removesuffix("°"))
    assert degrees == pytest.approx(math.degrees(math.hypot(SINE, COSINE)), abs=1.0)


def test_of_a_sound_compass_or_one_that_is_looked_for_nothing_is_said(swim: Callable[..., Any]) -> None:
    """A compass without iron; one beside a tracker that shows the yaw, where distortions have a name."""
    assert objections(seen(swim, sine=0.0, cosine=0.0)) == []
    assert objections(seen(swim, with_yaw=True)) == []


def test_beside_errors_of_readings_alone_nothing_is_asked(swim: Callable[..., Any]) -> None:
    """A clock that runs wrong is no motion."""
    assert objections(seen(swim), "clock_skew") == []
