"""What recordings do not show: readings that never vary, and a depth that nothing shows to change."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.findings import Unrecorded
from cocorosim_ros.diagnosis.showing.unrecorded import OF_DEPTH, unrecorded

MOVING = np.linspace(0.0, 1.0, 20)
FIXED = np.zeros(20)
ABSENT = np.full(20, np.nan)


def track(**streams: list[Any]) -> Any:
    """A recording with these columns of readings, by stream."""
    logs = {topic: SimpleNamespace(value=np.column_stack(columns)) for topic, columns in streams.items()}
    return SimpleNamespace(log=SimpleNamespace(streams=logs))


def test_a_fixed_height_is_no_reading() -> None:
    """Zero throughout, as a map writes it, in one recording or at another height in the next; once it moves, it is."""
    fixed = track(pose=[MOVING, MOVING, FIXED, MOVING])
    lower = track(pose=[MOVING, MOVING, FIXED - 2.0, MOVING])
    assert unrecorded([fixed]) == unrecorded([fixed, lower]) == Unrecorded(("pose_z",), depth=True)
    diving = track(pose=[MOVING, MOVING, MOVING, MOVING])
    assert unrecorded([diving]) == unrecorded([fixed, diving]) == Unrecorded()


def test_another_reading_shows_the_depth() -> None:
    """A pressure that varies, or a speed upwards, beside a height that is fixed."""
    height = [MOVING, MOVING, FIXED, MOVING]
    assert unrecorded([track(pose=height, pressure=[MOVING])]) == Unrecorded(("pose_z",))
    assert unrecorded([track(pose=height, velocity=[MOVING, MOVING, MOVING])]) == Unrecorded(("pose_z",))
    assert {"pose_z", "pressure", "velocity_w"} <= OF_DEPTH


def test_columns_without_a_number_are_not_there() -> None:
    """Neither steady nor varying; where nothing has a depth, nothing shows it."""
    flat = track(pose=[MOVING, MOVING, ABSENT, MOVING])
    assert unrecorded([flat]) == unrecorded([track(compass=[MOVING])]) == Unrecorded((), depth=True)


def test_a_diagnosis_says_that_the_height_is_fixed(swim: Any) -> None:
    """A Lily whose poses have the height of a map: that is no reading, and nothing is said of errors of it."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    evidence = swim(load_platform("lily"), 60.0)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    fixed = pose.value.copy()
    fixed[:, 2] = 0.0
    level = replace(log, streams={"pose": replace(pose, value=fixed)})
    evidence = replace(evidence, recordings=(replace(recording, robots=(level,)),))
    found = diagnose(evidence, lambda words, share: None)
    assert found.unrecorded == Unrecorded(("pose_z",), depth=True)
    assert not any("height" in sentence for sentence in found.untold)
    assert any("the pose along x" in sentence for sentence in found.untold)
