"""Alike recordings are asked how far they differ with the streams alone that the judged ones have."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.against.joint import joint_fit, with_streams_of
from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
from cocorosim_ros.scenario.parts.platform import load_platform


def without(evidence: Any, topic: str) -> Any:
    """The evidence without a stream."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {name: stream for name, stream in log.streams.items() if name != topic}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def test_a_stream_that_is_not_judged_says_nothing_of_alike_recordings(swim: Callable[..., Any]) -> None:
    """Its readings are left out and the rest is as it was; with all streams on both sides it is the very same fit."""
    lily = load_platform("lily")
    learned, bad = first_fit(swim(lily, 20.0, 1)), swim(lily, 20.0, 2)
    assert with_streams_of(learned, joint_fit(learned, bad)) is learned
    left = with_streams_of(learned, joint_fit(learned, without(bad, "compass")))
    (mine,), (its,) = left.tracks, learned.tracks
    assert mine.timeline.stream_names == [name for name in its.timeline.stream_names if name != "compass"]
    assert left.log_likelihood != learned.log_likelihood
    np.testing.assert_array_equal(left.filled, learned.filled)
