"""A track begins where its first readings put it under the errors that a model says these readings have."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.columns import COLUMN, SENSORS
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE, SURFACE_PRESSURE
from cocorosim_ros.world.state.state import YAW, X, Y, Z


def beginning(evidence: Any) -> tuple[Any, Any]:
    """How the one track of an evidence begins, and the row of its vehicle."""
    (track,) = make_tracks(evidence)
    return track.filter.beginning, track.vehicle.row


def without(evidence: Any, *topics: str) -> Any:
    """The evidence of one robot without some streams."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    streams = {name: stream for name, stream in log.streams.items() if name not in topics}
    return replace(evidence, recordings=(replace(recording, robots=(replace(log, streams=streams),)),))


def test_right_readings_begin_where_they_show(swim: Callable[..., Any]) -> None:
    """Without errors the start is that of the first readings, bit by bit."""
    begun, row = beginning(swim(load_platform("lily"), 10.0))
    assert begun.under(row[SENSORS]) is begun.start


def test_lengths_too_large_begin_nearer(swim: Callable[..., Any]) -> None:
    """A camera that shows lengths 1.15 times as long saw a robot that began at the place shown over 1.15."""
    begun, row = beginning(swim(load_platform("lily"), 10.0))
    row[COLUMN["camera_scale.scale"]] = 1.15
    found, shown = begun.under(row[SENSORS]).mean, begun.start.mean
    np.testing.assert_allclose(found[[X, Y, Z]], shown[[X, Y, Z]] / 1.15, rtol=1e-9)
    np.testing.assert_array_equal(found[YAW:], shown[YAW:])


@pytest.mark.parametrize("scale", [0.4, 2.5])
def test_a_scale_far_off_is_put_right_too(swim: Callable[..., Any], scale: float) -> None:
    """Steps with a slope of one would leave the place for scales above two."""
    begun, row = beginning(swim(load_platform("lily"), 10.0))
    row[COLUMN["camera_scale.scale"]] = scale
    assert begun.under(row[SENSORS]).mean[X] == pytest.approx(begun.start.mean[X] / scale, rel=1e-6)


def test_a_pressure_in_error_alone_shows_the_depth(swim: Callable[..., Any]) -> None:
    """Where pressure alone shows the depth, an offset of a metre of water begins a metre higher."""
    begun, row = beginning(without(swim(load_platform("lily"), 10.0), "pose"))
    row[COLUMN["pressure_offset.offset"]] = PASCAL_PER_METRE
    assert begun.under(row[SENSORS]).mean[Z] == pytest.approx(begun.start.mean[Z] + 1.0, abs=1e-6)
    row[COLUMN["pressure_offset.offset"]] = 0.0
    row[COLUMN["pressure_gain.gain"]] = 1.1
    depth = -begun.start.mean[Z]
    shown = SURFACE_PRESSURE + PASCAL_PER_METRE * depth
    told = {SURFACE_PRESSURE + PASCAL_PER_METRE * depth / 1.1, shown / 1.1}  # of the water's pressure, or of all of it
    found = SURFACE_PRESSURE - PASCAL_PER_METRE * begun.under(row[SENSORS]).mean[Z]
    assert min(abs(found - each) for each in told) < 1.0


def test_a_compass_in_error_alone_shows_the_heading(swim: Callable[..., Any]) -> None:
    """The heading is the one at which the distorted compass shows what it showed."""
    begun, row = beginning(without(swim(load_platform("lily"), 10.0), "pose"))
    row[COLUMN["compass_distortion.offset"]], row[COLUMN["compass_distortion.sin"]] = 0.2, 0.1
    heading = begun.under(row[SENSORS]).mean[YAW]
    off = heading + 0.2 + 0.1 * math.sin(heading) - begun.start.mean[YAW]
    assert abs(math.remainder(off, 2.0 * math.pi)) < 1e-6


def with_pose(evidence: Any, *, noise: float, later: float) -> Any:
    """The evidence of one robot, with poses of another noise [m] that begin later by so many seconds."""
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose = log.streams["pose"]
    kept = pose.time >= pose.time[0] + later
    told = np.concatenate([np.full(3, noise), pose.noise[3:]])
    pose = replace(pose, time=pose.time[kept], value=pose.value[kept], noise=told)
    robots = (replace(log, streams={"pose": pose, "imu": log.streams["imu"]}),)
    return replace(evidence, recordings=(replace(recording, robots=robots),))


@pytest.mark.parametrize(
    ("noise", "later", "low", "high"), [(0.001, 0.0, 0.05, 0.05), (0.4, 0.0, 1.2, 1.2), (0.001, 3.0, 0.1, 3.0)]
)
def test_a_start_is_as_sure_as_what_shows_it(
    swim: Callable[..., Any], noise: float, later: float, low: float, high: float
) -> None:
    """A camera shows a place to 5 cm, a satellite receiver to what it errs by; behind a wait a robot may have moved."""
    begun, _ = beginning(with_pose(swim(load_platform("lily"), 10.0), noise=noise, later=later))
    assert (begun.start.spread[[X, Y, Z]] >= low * (1.0 - 1e-9)).all()
    assert (begun.start.spread[[X, Y, Z]] <= high * (1.0 + 1e-9)).all()
