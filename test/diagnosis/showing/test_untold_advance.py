"""Poses that come earlier than all other readings are told as the reason against a skew that stands for them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from named_in_vain import case_of

from cocorosim_ros.diagnosis.fitting.climbing import settled
from cocorosim_ros.diagnosis.fitting.fit import evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.showing.untold_advance import untold_advance
from cocorosim_ros.scenario.parts.platform import load_platform

EARLY = 0.1  # s
SKEW = 1e-3  # s/s


def sentences(evidence: Any) -> list[str]:
    """What is said against a skew of the poses' clock that is fitted to the evidence and named."""
    case = case_of(base_fit(evidence), "clock_skew", topic="pose")
    final = settled(evaluated(case.final), 6)
    return [each.sentence for each in untold_advance(replace(case, final=final))]


def stamped(evidence: Any, stamps: Callable[[Any], Any]) -> Any:
    """The same evidence with other stamps of the poses."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    kept = stamps(pose.time) >= 0.0
    shifted = replace(pose, time=stamps(pose.time)[kept], value=pose.value[kept])
    robots = (replace(log, streams={**log.streams, "pose": shifted}),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


def test_early_poses_are_told_with_their_time(swim: Callable[..., Any]) -> None:
    """To a hundredth of a second, where poses are stamped before the rest; not where their clock runs fast."""
    lily = swim(load_platform("lily"), 200.0, 3)
    (told,) = sentences(stamped(lily, lambda time: time - EARLY))
    words = told.split()
    place = words.index("come")
    seconds = float(words[place + 1]) * {"s": 1.0, "ms": 1e-3}[words[place + 2]]
    assert np.isclose(seconds, EARLY, atol=0.01) and words[place + 3] == "early"
    assert sentences(stamped(lily, lambda time: (1.0 + SKEW) * time)) == []
