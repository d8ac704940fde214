"""Recordings that cannot be compared are refused in a sentence; what one side lacks is left out and said."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError


@pytest.fixture
def pair(swim: Any) -> tuple[Any, Any]:
    """Two recordings of half a minute."""
    from cocorosim_ros.scenario.parts.platform import load_platform

    return swim(load_platform("lily"), 30.0, seed=21), swim(load_platform("lily"), 30.0, seed=22)


def changed(evidence: Any, **changes: Any) -> Any:
    """The evidence with fields of its only log replaced; values may be functions of the log."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    made = {name: value(log) if callable(value) else value for name, value in changes.items()}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, **made),)),))


def streams(*names: str) -> Any:
    """A function of a log: those of its streams that have these names."""
    return lambda log: {name: log.streams[name] for name in names}


def test_a_stream_that_was_not_recorded_before_is_left_out(pair: tuple[Any, Any]) -> None:
    """The compass is taken out of the recordings to be judged, and a remark says so."""
    from cocorosim_ros.diagnosis.against.comparable import comparable

    bad, _ = comparable(pair[0], changed(pair[1], streams=streams("pose", "pressure")))
    (recording,) = bad.recordings
    assert set(recording.robots[0].streams) == {"pose", "pressure"}
    (remark,) = recording.remarks
    assert "has no compass, imu in the recordings of --against" in remark


def test_one_robot_is_compared_with_one_whatever_its_name(pair: tuple[Any, Any]) -> None:
    """The vehicle may have been called otherwise then; this is said, and of the same name nothing is."""
    from cocorosim_ros.diagnosis.against.comparable import comparable

    _, good = comparable(pair[0], changed(pair[1], name="before"))
    assert good.recordings[0].robots[0].name == pair[0].recordings[0].robots[0].name
    (remark,) = good.recordings[0].remarks
    assert remark.startswith("'before' is taken for 'lily_01' of the recordings to be judged")
    assert comparable(*pair)[1].recordings[0].remarks == ()


def in_hectopascals(log: Any) -> Any:
    """Streams of a log whose pressure is a hundredth of what it should be."""
    pressure = log.streams["pressure"]
    return {**log.streams, "pressure": replace(pressure, value=pressure.value / 100.0)}


def test_a_mixup_of_both_sides_is_no_difference_and_is_said_of_both(pair: tuple[Any, Any]) -> None:
    """Pressure in hectopascals here and there: both are put right, each side says so, and none is told to differ."""
    from cocorosim_ros.diagnosis.against.comparable import taken_in

    intake, well = taken_in(*(changed(side, streams=in_hectopascals) for side in pair))
    assert intake.mixups == ()
    (there,) = well.evidence.remarks
    assert there.startswith("lily_01/pressure: ") and there.endswith("it was put right.")
    (here,) = intake.evidence.remarks
    assert here.startswith("lily_01/pressure: ") and "hectopascals" in here
    assert here.endswith("in the recordings of --against; here it was put right alike.")
    pressure = intake.evidence.recordings[0].robots[0].streams["pressure"].value
    assert np.allclose(pressure, pair[0].recordings[0].robots[0].streams["pressure"].value)


def test_a_stream_that_cannot_be_put_right_is_left_out_on_both_sides(pair: tuple[Any, Any]) -> None:
    """What is not used there is missing here, with a remark; other robots' streams stay."""
    from cocorosim_ros.diagnosis.against.comparable import _put_right_alike
    from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection
    from cocorosim_ros.diagnosis.evidence.intake import Mixup

    (recording,) = pair[0].recordings
    hopeless = FrameCorrection("imu", "it is no rate of the yaw", "they were compared", 50.0, None, np.zeros(4))
    left = _put_right_alike(recording, [Mixup(("lily_01",), hopeless)])
    assert set(recording.robots[0].streams) - set(left.robots[0].streams) == {"imu"}
    (remark,) = left.remarks
    assert remark == "lily_01/imu: it is no rate of the yaw in the recordings of --against; here it is not used either."
    assert _put_right_alike(recording, [Mixup(("lily_02",), hopeless)]) == recording


def test_no_common_stream_is_refused(pair: tuple[Any, Any]) -> None:
    """Nothing can be compared; the sentence names both sides' streams."""
    from cocorosim_ros.diagnosis.against.comparable import comparable

    with pytest.raises(CocorosimError, match=r"--against has the streams pressure; the recordings .* compass"):
        comparable(changed(pair[0], streams=streams("compass")), changed(pair[1], streams=streams("pressure")))


def test_other_robots_are_refused(pair: tuple[Any, Any]) -> None:
    """With several robots names have to agree."""
    from cocorosim_ros.diagnosis.against.comparable import comparable

    (recording,) = pair[1].recordings
    others = tuple(replace(recording.robots[0], name=name) for name in ("a", "b"))
    good = replace(pair[1], recordings=(replace(recording, robots=others),))
    with pytest.raises(CocorosimError, match="--against has the robots a, b"):
        comparable(pair[0], good)


def test_commands_of_another_size_are_refused(pair: tuple[Any, Any]) -> None:
    """A tenth of the thrust shows little of what the vehicle does at full thrust."""
    from cocorosim_ros.diagnosis.against.comparable import comparable

    with pytest.raises(CocorosimError, match="--against has commands up to"):
        comparable(pair[0], changed(pair[1], command=lambda log: 0.1 * log.command))


def test_few_recordings_are_cut_into_parts(pair: tuple[Any, Any]) -> None:
    """A minute makes three parts of twenty seconds, which have every reading once and all commands."""
    from cocorosim_ros.diagnosis.against.comparable import in_parts

    (recording,) = pair[0].recordings
    cut = in_parts(replace(pair[0], recordings=(replace(recording, duration=60.0),)))
    assert len(cut.recordings) == 3
    for topic, stream in recording.robots[0].streams.items():
        parts = [each.robots[0].streams[topic].time for each in cut.recordings if topic in each.robots[0].streams]
        assert np.array_equal(np.concatenate(parts), stream.time)
    assert all(np.array_equal(each.robots[0].command, recording.robots[0].command) for each in cut.recordings)
