"""Velocities of level states in the axes of a robot that tilts, against rotations of scipy."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.tracks.body_velocity import body_velocity
from cocorosim_ros.diagnosis.tracks.track import Track, make_track
from cocorosim_ros.scenario.parts.platform import load_platform

SECONDS, HEADING_RATE = 20.0, 0.3


def angles(time: Any) -> Any:
    """Roll, pitch and heading (n, 3) [rad] of a robot that rolls to one side and nods as it turns."""
    return np.column_stack([0.3 + 0.1 * np.sin(0.2 * time), -0.4 + 0.2 * np.sin(0.3 * time), HEADING_RATE * time])


@pytest.fixture(scope="module")
def level() -> Track:
    """A Lily that is held level for as long."""
    time = np.arange(0.0, SECONDS, 0.1)
    streams = {"pose": Stream(time, np.zeros((len(time), 4)), np.full(4, 0.01))}
    log = RobotLog("lily_01", np.array([0.0]), np.zeros((1, 3)), streams)
    return make_track(load_platform("lily"), log, 0.0, SECONDS)


@pytest.fixture(scope="module")
def tilted(level: Track) -> Track:
    """The same Lily with roll and pitch."""
    time = np.arange(0.0, SECONDS, 0.01)
    roll, pitch, _ = angles(time).T
    return replace(level, log=replace(level.log, attitude=Attitude(time, roll, pitch)))


def states(time: Any) -> Any:
    """States (n, 8) that move ahead, aside and up along level axes."""
    speeds = [0.3 + 0.0 * time, 0.05 * np.sin(time), -0.1 + 0.0 * time, HEADING_RATE + 0.0 * time]
    return np.column_stack([np.zeros((len(time), 3)), HEADING_RATE * time, *speeds])


def test_a_level_robot_has_the_velocities_of_its_state(level: Track) -> None:
    """Along level axes, in water at rest."""
    time = np.arange(1.0, 19.0, 0.5)
    found = body_velocity(level, time, states(time), level.vehicle.row)
    assert (found.through_water == states(time)[:, 4:8]).all()
    assert (found.over_ground == states(time)[:, 4:8]).all()


def test_a_tilted_robot_moves_along_its_own_axes(tilted: Track) -> None:
    """Velocity of the world seen from the whole attitude, and the third rate by which that attitude turns.

    The rate of the pitch is differenced over a span in which its third derivative, 0.0054 rad/s^3, bends it little.
    """
    time = np.arange(1.0, 19.0, 0.5)
    found = body_velocity(tilted, time, states(time), tilted.vehicle.row).through_water
    whole = Rotation.from_euler("xyz", angles(time))
    heading = Rotation.from_rotvec(HEADING_RATE * time[:, None] * [0.0, 0.0, 1.0])
    assert found[:, :3] == pytest.approx(whole.inv().apply(heading.apply(states(time)[:, 4:7])), abs=1e-6)
    step = 1e-4
    later = Rotation.from_euler("xyz", angles(time + step))
    assert found[:, 3] == pytest.approx((whole.inv() * later).as_rotvec()[:, 2] / step, abs=1e-3)
