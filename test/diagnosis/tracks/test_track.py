"""A robot of a recording as the filter takes it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.scenario.parts.platform import load_platform


def test_a_robot_begins_with_its_own_numbers(swim: Callable[..., Any]) -> None:
    """What the platform's file says of this robot alone replaces what it says of all."""
    lily = load_platform("lily")
    other = replace(lily, robots={"lily_01": replace(lily, drag=2.5), "lily_02": replace(lily, drag=3.5)})
    (track,) = make_tracks(swim(lily, 20.0, base=other))
    assert track.vehicle.nominal[COLUMN["drag"]] == 2.5


def test_a_piece_begins_where_the_whole_was(swim: Callable[..., Any]) -> None:
    """Its grid, its forces and its readings are those of the whole from there on, also of thrusters that are late."""
    lily = load_platform("lily")
    (track,) = make_tracks(swim(lily, 20.0))
    piece = track.piece(100, 50)
    np.testing.assert_allclose(piece.timeline.grid.moments, track.timeline.grid.moments[100:150], rtol=0.0, atol=1e-9)
    row = track.vehicle.row
    row[COLUMN["thruster_lag.time_constant"]] = 2.0
    np.testing.assert_allclose(
        piece.actuation.drive(row).force, track.actuation.drive(row).force[100:150], rtol=0.0, atol=1e-12
    )
    assert piece.timeline.stamp.min() >= piece.timeline.grid.begin
    pose = track.log.streams["pose"]
    at = int(np.searchsorted(pose.time, piece.timeline.grid.begin))
    np.testing.assert_array_equal(piece.filter.beginning.start.mean[:4], pose.value[at])


def test_late_readings_and_late_commands_are_one_thing_where_all_readings_are_late(swim: Callable[..., Any]) -> None:
    """To the bit: the same likelihood, and no reading in another place on the grid."""
    (track,) = make_tracks(swim(load_platform("lily"), 20.0))
    readings, commands = track.vehicle.row.copy(), track.vehicle.row.copy()
    for name in track.timeline.stream_names:
        readings[COLUMN[f"sensor_latency.{name}"]] = 0.35
    commands[COLUMN["command_delay.delay"]] = 0.35
    late, delayed = (track.filter.full(row) for row in (readings, commands))
    np.testing.assert_array_equal(late.innovation, delayed.innovation)
    assert late.log_likelihood == delayed.log_likelihood != track.filter.full(track.vehicle.row).log_likelihood
    np.testing.assert_array_equal(track.timeline.under(readings).after, track.timeline.under(commands).after)


def test_a_stream_that_is_left_out_leaves_the_others_their_time(swim: Callable[..., Any]) -> None:
    """Late poses move, as they do beside a compass that is not late, where this compass is held out."""
    (track,) = make_tracks(swim(load_platform("lily"), 20.0))
    row = track.vehicle.row.copy()
    for name in track.timeline.stream_names[:-1]:
        row[COLUMN[f"sensor_latency.{name}"]] = 0.35
    held_out = track.without_stream(track.timeline.stream_names[-1])
    assert held_out.timeline.timing_under(row).latency["pose"] == 0.35
    assert held_out.piece(0, 50).timeline.timing_under(row).latency["pose"] == 0.35


def test_angles_change_by_the_shorter_way() -> None:
    """From just below half a turn to just below minus half a turn is a little more; what is not believed is 0."""
    own, other = (
        Pass(np.array(values), np.ones(3), np.zeros((3, 0)), np.array(believed), 0.0)
        for values, believed in (([3.1, 3.1, 0.5], [True, True, True]), ([-3.1, -3.1, 0.7], [True, True, False]))
    )
    np.testing.assert_allclose(
        own.change_to(other, np.array([True, False, False])), [2.0 * np.pi - 6.2, -6.2, 0.0], atol=1e-12
    )


def test_no_likelihood_leaps_where_a_heading_lies_half_a_turn_off(swim: Callable[..., Any]) -> None:
    """After a gap, a heading just under half a turn off and one just over it are equally likely, all told."""
    evidence = swim(load_platform("lily"), 12.0)
    (log,) = evidence.recordings[0].robots
    pose = log.streams["pose"]
    alone = np.flatnonzero(pose.time > 8.0)[0]
    kept = (pose.time < 6.0) | (pose.time > 8.3)
    kept[alone] = True

    def likelihood(turned: float) -> float:
        value = pose.value.copy()
        value[alone, 3] += turned
        stream = replace(pose, time=pose.time[kept], value=value[kept])
        only = replace(log, streams={"pose": stream})
        (track,) = make_tracks(replace(evidence, recordings=(replace(evidence.recordings[0], robots=(only,)),)))
        found = track.filter.full(track.vehicle.row)
        at = np.flatnonzero((track.timeline.stamp > 7.9) & (track.timeline.stamp < 8.2) & track.timeline.is_angle)
        own.append(float(found.innovation[at[0]]))
        return found.log_likelihood

    own: list[float] = []
    likelihood(0.0)
    half = np.pi - own[0]
    under, over = likelihood(half - 1e-7), likelihood(half + 1e-7)
    assert own[1] > 0.0 > own[2]
    assert under == pytest.approx(over, abs=1e-3)
