"""Roll and pitch as recorded: what they make of velocities, inertial readings and thrust, against closed forms."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cocorosim_ros.diagnosis.evidence.levelling import levelled
from cocorosim_ros.diagnosis.evidence.streams.attitude import Attitude, attitude_of, tilt_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.diagnosis.tracks.track import make_track
from cocorosim_ros.scenario.parts.platform import load_platform

TIME = np.arange(0.0, 30.0, 0.1)
ROLL, PITCH, YAW = 0.3 * np.sin(0.7 * TIME), 0.4 * np.sin(0.5 * TIME + 1.0), 0.2 * TIME
TURNS = Rotation.from_euler("ZYX", np.column_stack([YAW, PITCH, ROLL]))
HEADING = Rotation.from_euler("Z", YAW[:, None])
WORLD_VELOCITY = np.column_stack([0.3 * np.cos(0.2 * TIME), 0.2 * np.sin(0.4 * TIME), 0.1 * np.cos(0.9 * TIME)])


def log_of(attitude: Attitude | None, **streams: Any) -> RobotLog:
    """A log of one robot with streams of the given columns at TIME."""
    made = {topic: Stream(TIME, value, np.full(value.shape[1], 0.01)) for topic, value in streams.items()}
    return RobotLog("auv", TIME, np.zeros((len(TIME), 3)), made, attitude=attitude)


def heights() -> Any:
    """z of the course: the integral of the world's upward velocity, in closed form."""
    return 0.1 / 0.9 * np.sin(0.9 * TIME)


def poses() -> Any:
    """Poses whose height is that of the course."""
    return np.column_stack([np.zeros((len(TIME), 2)), heights(), YAW])


def test_quaternions_give_roll_and_pitch() -> None:
    """Any turn's roll and pitch, as SciPy has them."""
    tilt, said = tilt_of("auv/pose", TURNS.as_quat())
    np.testing.assert_allclose(tilt, np.column_stack([ROLL, PITCH]), atol=1e-12)
    assert said == ""


def test_a_level_robot_has_no_attitude() -> None:
    """Turns about the vertical alone, and orientations that are not given, leave everything as it is."""
    assert len(tilt_of("auv/pose", HEADING.as_quat())[0]) == 0
    assert len(tilt_of("auv/imu", np.full((9, 4), np.nan))[0]) == 0
    assert len(tilt_of("auv/imu", np.zeros((9, 4)))[0]) == 0
    assert attitude_of(TIME, tilt_of("auv/pose", HEADING.as_quat())[0]) is None


def test_an_orientation_that_is_not_normalised_is_said() -> None:
    """Quaternions of length 1.5 are no attitude: a sentence, and the others stay."""
    quaternion = TURNS.as_quat()
    quaternion[3:5] *= 1.5
    tilt, said = tilt_of("auv/pose", quaternion)
    assert said == (
        f"auv/pose: 2 of {len(TIME)} orientations are no unit quaternions (the first has the length 1.5); their roll "
        "and pitch are not used. Write x, y, z, w of length 1."
    )
    assert np.isnan(tilt[3:5]).all() and np.isfinite(tilt[5:]).all()


def test_velocities_and_forces_are_turned_into_level_axes() -> None:
    """Body vectors of a known world vector become those of a robot of the same heading that is level."""
    body = TURNS.inv().apply(WORLD_VELOCITY)
    level = HEADING.inv().apply(WORLD_VELOCITY)
    imu = np.column_stack([np.zeros(len(TIME)), body])
    logs = {"velocity": body, "ground_velocity": body}
    log, said = levelled(log_of(Attitude(TIME, ROLL, PITCH), pose=poses(), imu=imu, **logs))
    for topic in logs:
        np.testing.assert_allclose(log.streams[topic].value, level, atol=1e-12)
    np.testing.assert_allclose(log.streams["imu"].value[:, 1:], level, atol=1e-12)
    np.testing.assert_array_equal(log.streams["pose"].value, poses())
    assert len(said) == 1 and "taken as known" in said[0]


def test_the_gyroscope_gives_the_rate_of_the_heading() -> None:
    """The body's rate about its own z, of Euler's kinematics r = psi_dot cos cos - theta_dot sin, back to psi_dot."""
    pitch_rate = 0.4 * 0.5 * np.cos(0.5 * TIME + 1.0)
    rate = 0.2 * np.cos(ROLL) * np.cos(PITCH) - pitch_rate * np.sin(ROLL)
    imu = np.column_stack([rate, np.full((len(TIME), 3), np.nan)])
    log, _ = levelled(log_of(Attitude(TIME, ROLL, PITCH), imu=imu))
    np.testing.assert_allclose(log.streams["imu"].value[2:-2, 0], 0.2, atol=2e-3)


@pytest.mark.parametrize("topic", ["velocity", "ground_velocity"])
@pytest.mark.parametrize(("roll", "pitch", "word"), [(1.0, -1.0, "pitch"), (-1.0, 1.0, "roll")])
def test_a_mirrored_attitude_is_not_used(topic: str, roll: float, pitch: float, word: str) -> None:
    """Heights tell that a sign is wrong; then nothing is turned, and that is said."""
    body = TURNS.inv().apply(WORLD_VELOCITY)
    log, said = levelled(log_of(Attitude(TIME, roll * ROLL, pitch * PITCH), pose=poses(), **{topic: body}))
    assert log.attitude is None
    np.testing.assert_array_equal(log.streams[topic].value, body)
    assert f"better with {word} of the opposite sign; roll and pitch are not used" in said[0]


def test_a_robot_on_its_back_is_in_other_axes() -> None:
    """Forward-right-down looks upside down; nothing is turned."""
    log, said = levelled(log_of(Attitude(TIME, ROLL + math.pi, PITCH)))
    assert log.attitude is None and "upside down" in said[0]


def test_thrust_is_projected() -> None:
    """A vehicle that holds its nose down by 0.3 rad pushes cos(0.3) of its thrust ahead and sin(0.3) downwards."""
    lily = load_platform("lily")
    pitch = np.full(len(TIME), 0.3)
    log = log_of(Attitude(TIME, 0.0 * TIME, pitch), pose=poses())
    log = replace(log, command=np.tile([0.5, 0.5, 0.0], (len(TIME), 1)))
    track = make_track(lily, log, 0.0, 29.0)
    thrust = track.actuation.thrust(track.actuation.drive(track.vehicle.row))
    full = 0.5 * 2 * 0.005
    np.testing.assert_allclose(thrust[5:-5, 0], full * math.cos(0.3), rtol=1e-12)
    np.testing.assert_allclose(thrust[5:-5, 2], -full * math.sin(0.3), rtol=1e-12)
    np.testing.assert_allclose(thrust[5:-5, 1], 0.0, atol=1e-18)
    start = np.zeros(8)
    path = track.filter.free_run(track.vehicle.row, start, 0, 200)
    assert path[-1, 2] < -0.1  # it dives by its thrusters alone


def test_a_speed_ahead_is_levelled_by_the_climb() -> None:
    """Of a hull without way sideways: u / cos(theta) + climb tan(theta), to what differences over a second leave."""
    climb = WORLD_VELOCITY[:, 2]
    along = 1.0 + 0.1 * np.sin(0.3 * TIME)  # level speed ahead
    body = np.column_stack([along * np.cos(PITCH) - climb * np.sin(PITCH), np.full((len(TIME), 2), np.nan)])
    pressure = (101325.0 - 9806.65 * (heights() - 5.0))[:, None]
    log, remarks = levelled(log_of(Attitude(TIME, 0.0 * TIME, PITCH), velocity=body, pressure=pressure))
    level = log.streams["velocity"].value
    np.testing.assert_allclose(level[10:-10, 0], along[10:-10], atol=0.01)
    assert np.ptp(body[:, 0] - along) > 0.1
    assert np.isnan(level[:, 1:]).all()
    assert not any("stays level" in remark for remark in remarks)


@pytest.mark.parametrize(
    ("velocity", "size", "said"),
    [(slice(0, 3), 1.0, False), (slice(0, 1), 1.0, True), (slice(0, 1), 0.1, False)],
    ids=["all three axes", "surge alone", "surge alone, hardly tilted"],
)
def test_a_hull_that_pitches_unseen_is_said(velocity: slice, size: float, said: bool) -> None:
    """Drag and lift are those of a level hull where no velocity tells how the water meets it."""
    attitude = attitude_of(TIME, size * np.column_stack([ROLL, PITCH]))
    value = np.full((len(TIME), 3), np.nan)
    value[:, velocity] = WORLD_VELOCITY[:, velocity]
    _, remarks = levelled(log_of(attitude, velocity=value))
    assert any("stays level" in remark for remark in remarks) is said
    assert any("taken as known" in remark for remark in remarks)
