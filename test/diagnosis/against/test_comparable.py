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
    """The vehicle may have been called otherwise then."""
    from cocorosim_ros.diagnosis.against.comparable import comparable

    _, good = comparable(pair[0], changed(pair[1], name="before"))
    assert good.recordings[0].robots[0].name == pair[0].recordings[0].robots[0].name


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
