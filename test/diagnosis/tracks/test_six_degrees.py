"""Simulated in six degrees of freedom, diagnosed in four: what a filter foretells of a torpedo that climbs, turning."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.diagnosis.evidence.intake import take_in
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.results import recording_metadata
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario

SCENARIO = """\
name: torpedo
description: a torpedo that changes its depth while its rudder swings
seed: 1
tick: 0.1 s
duration: 100 s
tank: {size: [2000 m, 2000 m, 100 m]}
integrator: {name: rk4, step: 0.02 s, contact: inelastic}
swarm:
  - platform: remus100
    prefix: auv
    controller: {file: torpedo.py:Torpedo}
    start: {poses: [[0 m, 0 m, -20 m, 30 deg]]}
"""
CONTROLLER = """\
import math


class Torpedo:
    def __call__(self, sensed):
        time, depth = sensed.time, (sensed.pressure - 101325.0) / (1030.0 * 9.81)
        ahead, left, up = sensed.specific_force
        pitch = math.atan2(ahead, math.hypot(left, up))
        wanted = min(0.25, max(-0.25, 0.1 * (depth - 20.0 - 3.0 * math.sin(time / 14.0))))
        planes = min(1.0, max(-1.0, -3.0 * (wanted - pitch)))
        rudders = 0.35 * math.sin(time / 4.6) + 0.15 * math.sin(time / 1.4)
        return {"propeller": 0.7 + 0.3 * math.sin(time / 5.9), "rudders": rudders, "stern_planes": planes}
"""


@pytest.fixture(scope="module")
def torpedo(tmp_path_factory: pytest.TempPathFactory) -> Track:
    """The track of a torpedo, recorded without noise."""
    folder = tmp_path_factory.mktemp("torpedo")
    (folder / "torpedo.yaml").write_text(SCENARIO, "utf-8")
    (folder / "torpedo.py").write_text(CONTROLLER, "utf-8")
    scenario = load_scenario(folder / "torpedo.yaml")
    record = RunRecord(folder / "bag", [describe_body(each) for each in scenario.robots], recording_metadata(scenario))
    run_in_process(scenario, record)
    record.close()
    evidence = take_in(gather_evidence([folder / "bag"], in_four_degrees(load_platform("remus100")))).evidence
    (track,) = make_tracks(evidence)
    return track


def shown(track: Track, moment: float) -> Any:
    """State (8,) at a moment [s], as it was recorded: x, y, z, heading, and velocities along and about level axes."""
    streams = track.log.streams
    parts = [(streams["pose"], range(4)), (streams["velocity"], range(3)), (streams["imu"], range(1))]
    return np.array(
        [np.interp(moment, stream.time, stream.value[:, column]) for stream, columns in parts for column in columns]
    )


def strayed(track: Track, first: int) -> Any:
    """By how much (3,) the platform's own model strays in 20 s in place, depth and heading [m, m, rad]."""
    moments = track.timeline.grid.moments[first : first + round(20.0 / track.timeline.grid.step) + 1]
    path = track.filter.free_run(track.vehicle.row, shown(track, moments[0]), first, len(moments))
    off = path - np.array([shown(track, moment) for moment in moments])
    return np.array([np.hypot(off[:, 0], off[:, 1]).max(), np.abs(off[:, 2]).max(), np.abs(off[:, 3]).max()])


def test_it_foretells_a_climbing_turn(torpedo: Track) -> None:
    """For 20 s and 8 to 10 m, in which it pitches by 20 degrees: to a hundredth of its way, 2 cm and half a degree.

    With fins that push along level axes it strays by 1.8 m, 0.27 m and 20 degrees.
    """
    moments = torpedo.timeline.grid.moments
    for first in (50, 150, 250, 350):
        way = shown(torpedo, moments[first + 200])[:2] - shown(torpedo, moments[first])[:2]
        assert torpedo.log.attitude is not None
        assert np.abs(torpedo.log.attitude.pitch_at(moments[first : first + 200])).max() > np.radians(20.0)
        place, depth, heading = strayed(torpedo, first)
        assert place < 0.01 * np.hypot(*way)
        assert depth < 0.02
        assert heading < np.radians(0.5)
