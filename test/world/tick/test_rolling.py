"""Robots with six degrees of freedom in whole runs: what they show, walls, batches, and what is refused."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.highlevel import AnyReader
from scipy.spatial.transform import Rotation

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.between_ticks import steps_of_scenario
from cocorosim_ros.library.record import record
from cocorosim_ros.library.simulate import simulate, simulate_runs
from cocorosim_ros.wire.cdr.type_store import type_store
from cocorosim_ros.world.checks.loading import load_scenario

SCENARIO = """\
name: rov
description: an ROV
seed: 1
tick: 0.1 s
duration: 20 s
tank: {size: [20 m, 20 m, 10 m]}
integrator: {name: rk4, step: 0.05 s, contact: inelastic}
swarm:
  - {platform: bluerov2_heavy, prefix: rov, controller: CONTROLLER, start: {poses: [[0 m, 0 m, -5 m, 30 deg]]}}
"""
COMMANDS = """\
class Rolls:
    def __call__(self, sensed):
        return dict(zip(("up_front_left", "up_rear_left", "up_front_right", "up_rear_right"), (0.3, 0.3, -0.3, -0.3)))
"""


@pytest.fixture
def scenario(tmp_path: Path) -> Any:
    """Function of (text replaced, by what): a scenario file; its controller, `rolls`, pushes up left and down right."""
    (tmp_path / "own.py").write_text(COMMANDS)

    def write(old: str = "CONTROLLER", new: str = "idle") -> Path:
        path = tmp_path / "rov.yaml"
        text = SCENARIO.replace(old, new).replace("CONTROLLER", "{file: own.py:Rolls}")
        path.write_text(text)
        return path

    return write


def test_idle_vehicle_sinks_upright_and_feels_gravity(scenario: Any) -> None:
    """0.982 N of weight too many: 33 w + 190 w^2 at the end, and at first 0.982 N over 32.18 kg."""
    run = simulate(scenario())
    terminal = (math.sqrt(33.0**2 + 4 * 190.0 * 0.982) - 33.0) / 380.0
    assert run.velocity[-1, 0] == pytest.approx([0.0, 0.0, -terminal], abs=1e-9)
    assert run.attitude[-1, 0] == pytest.approx([0.0, 0.0, math.sin(math.pi / 12), math.cos(math.pi / 12)], abs=1e-12)
    force = run.readings["specific_force"][:, 0]
    assert force[0] == pytest.approx([0.0, 0.0, 9.82 - 0.982 / (13.5 + 18.68)], rel=1e-12)
    assert force[-1] == pytest.approx([0.0, 0.0, 9.82], abs=1e-8)


def test_rolling_vehicle_shows_roll_in_pose_and_imu(scenario: Any) -> None:
    """A couple about x: the quaternion turns at the gyroscope's rate, and places move by the velocity that it turns."""
    run = simulate(scenario("unused", ""))
    attitude = Rotation.from_quat(run.attitude[:, 0].copy())
    step = (attitude[:-1].inv() * attitude[1:]).as_rotvec() / 0.1
    gyro = run.readings["angular_rate"][:, 0]
    middle = 0.5 * (gyro[:-1] + gyro[1:])
    assert np.abs(gyro[:, 0]).max() > 0.5
    assert step[50:, 0] == pytest.approx(middle[50:, 0], abs=0.02)
    world = attitude.apply(run.velocity[:, 0].copy())
    moved = np.diff(run.position[:, 0], axis=0) / 0.1
    assert np.abs(moved - 0.5 * (world[:-1] + world[1:])).max() < 0.02


def test_recording_holds_the_whole_quaternion(scenario: Any, tmp_path: Path) -> None:
    """The poses of a bag are those of the run; its yaw is the bow's heading."""
    path = scenario("unused", "")
    bag, run = record(path, tmp_path / "bag", duration="3 s"), simulate(path, duration="3 s")
    with AnyReader([tmp_path / "bag"], default_typestore=type_store()) as reader:
        wanted = [each for each in reader.connections if each.topic == "/rov_01/pose"]
        turns = [reader.deserialize(data, each.msgtype).pose.orientation for each, _, data in reader.messages(wanted)]
    assert np.array_equal([[turn.x, turn.y, turn.z, turn.w] for turn in turns], run.attitude[:, 0])
    bow = Rotation.from_quat(run.attitude[:, 0].copy()).apply([1.0, 0.0, 0.0])
    assert bag.tracks["rov_01"].yaw == pytest.approx(np.arctan2(bow[:, 1], bow[:, 0]), abs=1e-6)
    assert np.abs(run.attitude[-1, 0, 0]) > 0.1


def test_poses_between_ticks_are_refused(scenario: Any) -> None:
    """They are made for four degrees of freedom."""
    with pytest.raises(CocorosimError, match="six"):
        steps_of_scenario(load_scenario(scenario()), 20.0, 1.0)


def test_many_runs_are_as_one(scenario: Any) -> None:
    """Two runs at once are bit for bit the runs alone."""
    path = scenario("unused", "")
    alone = simulate(path, duration="5 s")
    for run in simulate_runs(path, 2, duration="5 s"):
        assert np.array_equal(run.attitude, alone.attitude)
        assert np.array_equal(run.readings["specific_force"], alone.readings["specific_force"])


def test_floor_stops_it(scenario: Any) -> None:
    """With 0.2 m of water below it, an idle vehicle lies on the floor after 20 s of sinking at 26 mm/s."""
    path = scenario()
    path.write_text(path.read_text().replace("-5 m, 30 deg", "-9.8 m, 30 deg"))
    run = simulate(path)
    assert run.position[-1, 0, 2] == -10.0
    assert run.velocity[-1, 0, 2] == 0.0


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("name: rk4", "name: semi_implicit_euler", "six degrees of freedom, for which 'rk4' alone"),
        ("step: 0.05 s", "step: 0.5 s", "stable for the platform 'bluerov2_heavy'"),
        ("tick: 0.1 s", "tick: 0.5 s\nwater: {force_currents: {patch: 1 m, strength: 0.001 N}}", "water"),
    ],
)
def test_what_has_no_part_is_refused(scenario: Any, old: str, new: str, sentence: str) -> None:
    """Each in one sentence that says what to do."""
    path = scenario(old, new)
    path.write_text(path.read_text().replace("tick: 0.1 s", "tick: 0.5 s").replace("{file: own.py:Rolls}", "idle"))
    with pytest.raises(CocorosimError, match=sentence):
        load_scenario(path)
