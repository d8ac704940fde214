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
    assert unrecorded([flat]) == Unrecorded(absent=("pose_z",), depth=True)
    assert unrecorded([track(compass=[MOVING])]) == Unrecorded(depth=True)
    assert unrecorded([flat, track(pose=[MOVING] * 4)]) == Unrecorded()


def at_one_height(evidence: Any) -> Any:
    """Recordings of one robot with poses alone, the height of each of which a map has fixed."""
    recordings = []
    for recording in evidence.recordings:
        (log,) = recording.robots
        pose = log.streams["pose"]
        fixed = pose.value.copy()
        fixed[:, 2] = 0.0
        level = replace(log, streams={"pose": replace(pose, value=fixed)})
        recordings.append(replace(recording, robots=(level,)))
    return replace(evidence, recordings=tuple(recordings))


def test_a_comparison_says_that_the_height_is_fixed(swim: Any) -> None:
    """Nothing on its page is of depth either: no row, no picture, no size from which a difference would show."""
    from cocorosim_ros.diagnosis.diagnose_against import diagnose_against
    from cocorosim_ros.diagnosis.report.recorded import as_recorded
    from cocorosim_ros.scenario.parts.platform import load_platform

    lily = load_platform("lily")
    bad, good = (at_one_height(swim(lily, 60.0, seed=seed)) for seed in (1, 2))
    found = diagnose_against(bad, good, lambda words, share: None)
    assert found.unrecorded == Unrecorded(("pose_z",), depth=True)
    shown = as_recorded(found, lily)
    assert found.against is not None and shown.against is not None
    assert "depth" in found.fit and "depth" not in shown.fit
    assert "pump_lag" in found.against.seen_from and "hull_compressibility" in found.against.seen_from
    assert {"pump_lag", "hull_compressibility"}.isdisjoint(shown.against.seen_from)
    assert not any("heave" in number for numbers in shown.against.seen_from.values() for number in numbers)


def test_a_diagnosis_says_that_the_height_is_fixed(swim: Any) -> None:
    """A Lily whose poses have the height of a map: that is no reading, and nothing is said of errors of it."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    found = diagnose(at_one_height(swim(load_platform("lily"), 60.0)), lambda words, share: None)
    assert found.unrecorded == Unrecorded(("pose_z",), depth=True)
    assert not any("height" in sentence for sentence in found.untold)
    assert any("the pose along x" in sentence for sentence in found.untold)
