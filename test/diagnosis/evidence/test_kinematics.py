"""Streams that are rates of one another contradict each other where a column is wrong, however slow the vehicle is."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.frames.kinematics import contradictions, is_smooth
from cocorosim_ros.diagnosis.evidence.frames.motion import motion_of
from cocorosim_ros.diagnosis.evidence.frames.needed_corrections import needed_corrections
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.diagnosis.evidence.intake import Intake, take_in
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.diagnosis.showing.framing import mixed_up, unexplained
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

DATA = Path(__file__).resolve().parents[4] / "shared" / "data" / "kvlcc2_hsva"
TIME = np.arange(0.0, 300.0, 0.2)
YAW = 0.35 * np.sin(2.0 * np.pi * TIME / 75.0)  # four swings of a zigzag
RATE = 0.35 * 2.0 * np.pi / 75.0 * np.cos(2.0 * np.pi * TIME / 75.0)
BODY = 1.2 - 0.3 * YAW**2 - 1.5j * RATE  # u + iv [m/s]: it slows down and drifts outwards as it turns
WORLD = BODY * np.exp(1j * YAW)
ROLL_RATE = 0.3 * np.gradient(RATE, 0.2) + 0.002 * np.sin(2.0 * np.pi * TIME / 9.0)


@pytest.fixture
def slow(lily_platform: Platform) -> Platform:
    """A Lily that weighs 9 kg: in four minutes and a half it may lose half of its speed four times."""
    return replace(lily_platform, mass=9.0, yaw_inertia=0.0405, yaw_drag=1.14e-2)


def zigzag(yaw: Any = YAW, body: Any = BODY, rate: Any = RATE, noise: float = 1.0) -> RobotLog:
    """The log of a zigzag: poses, velocities and a gyroscope with noise, commands of little account."""
    rng = np.random.default_rng(3)
    place = np.cumsum(WORLD) * 0.2

    def noisy(columns: Any, spread: Any) -> Stream:
        columns = np.column_stack(columns)
        return Stream(TIME, columns + noise * np.asarray(spread) * rng.standard_normal(columns.shape), np.array(spread))

    nothing = np.full(len(TIME), np.nan)
    streams = {
        "pose": noisy([place.real, place.imag, np.full(len(TIME), -1.0), yaw], [0.01, 0.01, 0.01, 0.002]),
        "velocity": noisy([body.real, body.imag, 0.0 * TIME], [0.02, 0.02, 0.02]),
        "imu": noisy([rate, nothing, nothing, nothing], [0.003, 0.1, 0.1, 0.1]),
    }
    command = np.column_stack([0.5 + 0.2 * np.sign(YAW), 0.5 - 0.2 * np.sign(YAW), 0.0 * TIME])
    return RobotLog("ship", TIME, command, streams)


def test_what_fits_is_left(slow: Platform) -> None:
    """Right columns, also of a gyroscope that is late or scaled by a fifth, and of one whose noise hides the turns."""
    late, noise = np.interp(TIME - 0.4, TIME, RATE), np.random.default_rng(4).standard_normal(len(TIME))
    for rate in (RATE, 1.2 * late, RATE + noise):
        assert needed_corrections(zigzag(rate=rate), slow) == ()
        assert list(contradictions(motion_of(zigzag(rate=rate), slow))) == []


def test_earth_velocities_in_body_columns(slow: Platform) -> None:
    """Four swings tell it, because the velocities of the poses are foretold to the noise."""
    (correction,) = needed_corrections(zigzag(body=WORLD), slow)
    assert correction.topic == "velocity" and correction.into_body
    assert correction.wrong == "it is in world axes instead of body axes"


def test_degrees_for_radians(slow: Platform) -> None:
    """Of a gyroscope they are put right; of a yaw that was wrapped as radians they cannot be, and it is not used."""
    (gyro,) = needed_corrections(zigzag(rate=np.degrees(RATE)), slow)
    assert gyro.topic == "imu" and "degrees per second" in gyro.wrong
    (yaw,) = contradictions(motion_of(zigzag(yaw=np.degrees(YAW)), slow))
    assert (yaw.topic, yaw.matrix) == ("pose", None) and yaw.wrong == "its yaw is in degrees instead of radians"


def test_another_column_as_yaw_rate(slow: Platform) -> None:
    """The rate of the roll follows the turns a little, and is not their rate; nothing else is taken for its cause."""
    (correction,) = contradictions(motion_of(zigzag(rate=ROLL_RATE), slow))
    assert (correction.topic, correction.matrix) == ("imu", None)
    assert correction.wrong == "its yaw rate is not the rate at which the heading turns"


def test_a_velocity_of_something_else(slow: Platform) -> None:
    """No axes make it that of the poses."""
    other = 0.3 * np.sin(2.0 * np.pi * TIME / 31.0) + 0.2j * np.cos(2.0 * np.pi * TIME / 23.0)
    found = contradictions(motion_of(zigzag(body=other), slow))
    assert [correction.topic for correction in found] == ["velocity"]


def intake_of(log: RobotLog, platform: Platform) -> Intake:
    """The intake of one recording of this log."""
    return take_in(Evidence(platform, (RecordingLog("lake/bag", 300.0, (log,)),)))


def test_it_is_said_and_stops_names(slow: Platform) -> None:
    """A remark, a finding, a stream that is left out, and a sentence against whatever else is found."""
    intake = intake_of(zigzag(rate=ROLL_RATE), slow)
    (recording,) = intake.evidence.recordings
    assert sorted(recording.robots[0].streams) == ["pose", "velocity"]
    assert any("not the rate at which the heading turns" in remark for remark in recording.remarks)
    (effect,) = mixed_up(intake)
    assert (effect.id, effect.topic) == ("frame_mixup", "imu")
    (objection,) = unexplained(intake)
    assert "The imu of ship contradicts other readings" in objection.sentence
    assert not objection.concerns(effect)
    assert objection.concerns(replace(effect, id="thruster_lag", correction=None))
    assert unexplained(intake_of(zigzag(), slow)) == ()


@pytest.mark.parametrize(("values", "smooth"), [(RATE, True), (np.random.default_rng(0).normal(size=500), False)])
def test_motion_is_told_from_noise(values: Any, smooth: bool) -> None:
    """White noise is not like itself two moments later; swings are."""
    assert is_smooth(values) is smooth


MAP = """
name: ship
description: columns of a towing tank, some of them in wrong places
format: csv
tables:
  - files: "{run}.csv"
    layout: {separator: space, header: false, skip: 4}
    time: {column: 1, unit: s}
    robot: ship
    streams:
      pose: {axes: ned_frd, x: {column: 2, unit: m}, y: {column: 3, unit: m}, z: {fixed: 0 m},
        yaw: {column: 4, unit: deg}}
      velocity: {axes: ned_frd, x: {column: 5, unit: m/s}, y: {column: 6, unit: m/s}}
      imu: {axes: ned_frd, rate_z: {column: RATE, unit: deg/s}}
      thruster_command:
        left: {column: 9, unit: deg, stop: 0 deg, forward: 40 deg, reverse: -40 deg}
        right: {column: 9, unit: deg, stop: 0 deg, forward: 40 deg, reverse: -40 deg}
        buoyancy: {column: 9, unit: deg, stop: 0 deg, forward: 40 deg, reverse: -40 deg}
"""


@pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")
@pytest.mark.parametrize(("column", "topics"), [(7, ["velocity"]), (8, ["imu", "velocity"])])
def test_a_tanker_with_wrong_columns(column: int, topics: list[str], tmp_path: Path, slow: Platform) -> None:
    """Earth velocities in body columns (5, 6), and the roll rate (8) in place of the yaw rate (7)."""
    text = (DATA / "HSVA_CPMC_KVLCC2_Z_35_05.dat").read_text("latin-1")
    (tmp_path / "run.csv").write_text("\n".join(" ".join(line.split()) for line in text.splitlines()) + "\n")
    (tmp_path / "map.yaml").write_text(MAP.replace("RATE", str(column)))
    convert(load_map(tmp_path / "map.yaml"), tmp_path / "run.csv", tmp_path / "bag")
    intake = take_in(gather_evidence([tmp_path / "bag"], replace(slow, mass=4.0)))
    assert intake.reasons == ()
    found = {mixup.correction.topic: mixup.correction for mixup in intake.mixups}
    assert sorted(found) == topics
    assert "world axes instead of body axes" in found["velocity"].wrong
    assert "imu" not in found or found["imu"].matrix is None


POOL = DATA.parent / "tauv_pool"


@pytest.mark.skipif(not POOL.is_dir(), reason="the recordings of others are not on this machine")
def test_a_late_speed_log_contradicts_nothing(tmp_path: Path) -> None:
    """Positions and velocities of the AUV in the pool are one motion, though these come a quarter of a second late."""
    convert(load_map(find_config("maps", "tauv_pool")), POOL / "navigation_state_04.csv", tmp_path / "bag")
    assert take_in(gather_evidence([tmp_path / "bag"], load_platform("tauv_pool"))).mixups == ()
