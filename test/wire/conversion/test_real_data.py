"""Recordings made by others, where they are on this machine: they convert, and mean what the maps' comments say."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.study.metrics.from_tracks import measure_samples, sample_tracks
from cocorosim_ros.wire.bags.tracks import read_poses
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

DATA = Path(__file__).resolve().parents[4] / "shared" / "data"
Messages = Callable[[Path], dict[str, list[Any]]]

pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")


def test_hovercraft_runs(tmp_path: Path) -> None:
    """Twelve runs become twelve recordings, of which statistics can be computed."""
    done = convert(load_map(find_config("maps", "hovercraft_epfl")), DATA / "hovercraft_epfl", tmp_path / "bags")
    assert len(done) == 12
    track = read_poses(done[0].folder)
    samples = sample_tracks(track)
    assert samples.names == ("hovercraft",)
    assert "shoal_speed" in "".join(measure_samples(samples).summary()["metrics"])
    commands = done[6].conversion.streams[1]
    assert commands.topic == "thruster_command"
    assert np.unique(commands.rows.values).tolist() == [0.0, 1.0]


def test_hovercraft_turns_as_its_platform_says(tmp_path: Path) -> None:
    """More yaw rate after commands to the right propeller than to the left one: the axes are right-handed."""
    source = DATA / "hovercraft_epfl" / "pose_2019-04-16-11-28-36.csv"
    done = convert(load_map(find_config("maps", "hovercraft_epfl")), source, tmp_path / "bag")[0]
    pose, command = sorted(done.conversion.streams, key=lambda stream: stream.topic)
    track = read_poses(done.folder)["hovercraft"]
    gained = {"left": [], "right": []}  # yaw accelerations by which propeller pushes alone
    for moment, (left, right) in zip(command.stamp_ns, command.rows.values, strict=True):
        if left == right:
            continue
        near = np.abs(track.stamp_ns - moment - 110_000_000) < 60_000_000
        if np.count_nonzero(near) > 6:
            time = (track.stamp_ns[near] - moment) / 1e9
            gained["left" if left else "right"].append(2 * np.polyfit(time, np.unwrap(track.yaw[near]), 2)[0])
    wrench = load_platform("hovercraft_epfl").actuator_wrenches()[:, 3]
    measured = [np.median(gained["left"]), np.median(gained["right"])]
    assert np.sign(wrench).tolist() == np.sign(measured).tolist() == [-1, 1]
    assert pose.topic == "pose"


def test_haizhe_dive(tmp_path: Path, messages: Messages) -> None:
    """A dive has depth, heading, rates and commands of four propellers, all 20 times a second, and no pose."""
    source = DATA / "haizhe_auv" / "reference" / "run_000.csv"
    convert(load_map(find_config("maps", "haizhe_auv")), source, tmp_path / "bag")
    topics = messages(tmp_path / "bag")
    rows = np.genfromtxt(source, delimiter=",", names=True)
    assert set(topics) == {f"/haizhe/{name}" for name in ("pressure", "compass", "imu", "thruster_command")}
    pressure = np.array([message.content.fluid_pressure for message in topics["/haizhe/pressure"]])
    np.testing.assert_allclose((pressure - 101325) / 9810, rows["depth"], atol=1e-12)
    assert topics["/haizhe/compass"][20].at == 1_000_000_000
    command = topics["/haizhe/thruster_command"][50].content
    assert tuple(command.name) == load_platform("haizhe_auv").actuator_names
    assert command.command[0] == pytest.approx((rows["pwm1"][50] - 1100) / 800)


def test_killifish(tmp_path: Path) -> None:
    """124 tracks in 247 frames, and statistics of them."""
    convert(load_map(find_config("maps", "killifish")), DATA / "killifish", tmp_path / "bag")
    tracks = read_poses(tmp_path / "bag")
    table = np.genfromtxt(DATA / "killifish" / "rawdata_track.csv", delimiter=",", names=True)
    first = table[table["id"] == 1]
    assert len(tracks) == 124
    np.testing.assert_allclose(tracks["fish_001"].position[:, 0], first["col_x"] / 1000, atol=1e-15)
    np.testing.assert_allclose(tracks["fish_001"].position[:, 1], -first["row_y"] / 1000, atol=1e-15)
    samples = sample_tracks(dict(tracks))
    assert len(samples.stamp_ns) == 247
    metrics = measure_samples(samples).summary()["metrics"]
    assert 0.0 < metrics["polarisation_travel"]["mean"] < 1.0


def test_pool(tmp_path: Path) -> None:
    """Sixteen minutes; the velocity turned by the pose's attitude is its rate, within the lag of the speed log."""
    done = convert(load_map(find_config("maps", "tauv_pool")), DATA / "tauv_pool", tmp_path / "bags")
    assert len(done) == 16
    streams = {stream.topic: stream for stream in done[4].conversion.streams}
    time = (streams["pose"].stamp_ns - streams["pose"].stamp_ns[0]) / 1e9
    pose, velocity, command = (streams[topic].rows.values for topic in ("pose", "velocity", "thruster_command"))
    turned = Rotation.from_quat(pose[:, 3:7]).apply(velocity[:, :3])
    span = np.arange(1.0, time[-1] - 1.0, 0.5)
    for axis in range(3):
        moved = np.interp(span + 0.25, time, pose[:, axis]) - np.interp(span - 0.25, time, pose[:, axis])
        assert np.corrcoef(moved, np.interp(span, time, turned[:, axis]))[0, 1] > 0.9
    assert np.abs(command).max() < 1.0
    assert command.shape[1] == len(load_platform("tauv_pool").actuators)


def test_flights(tmp_path: Path) -> None:
    """Each of 22 flights has one pair of thrusts; the stronger right one turns it to the left, as its platform says."""
    done = convert(load_map(find_config("maps", "rgblimp")), DATA / "rgblimp", tmp_path / "bags")
    assert len(done) == 22
    wrench = load_platform("rgblimp").actuator_wrenches()[:, 3] * load_platform("rgblimp").actuator_limits()[:, 0]
    for made in done:
        command = next(stream for stream in made.conversion.streams if stream.topic == "thruster_command").rows.values
        np.testing.assert_allclose(command, np.tile(command[0], (len(command), 1)), rtol=1e-9)
        track = read_poses(made.folder)["blimp"]
        turned = np.unwrap(track.yaw)[-1] - np.unwrap(track.yaw)[0]
        assert command[0] @ wrench == pytest.approx(0.0, abs=1e-12) or turned > 0.0


def test_glider(tmp_path: Path) -> None:
    """It sinks with its nose down and its pump at full displacement downwards, and rises with both turned round."""
    done = convert(load_map(find_config("maps", "slocum_glider")), DATA / "slocum_glider", tmp_path / "bags")
    assert [made.folder.name for made in done] == ["A", "B"]
    for made in done:
        streams = {stream.topic: stream.rows.values for stream in made.conversion.streams}
        depth = (streams["pressure"][:, 0] - 101325.0) / (1005 * 9.81)
        assert 0.0 < depth.min() < 1.0 and 40.0 < depth.max() < 45.0
        ballast = streams["thruster_command"][:, 0]
        under = (depth > 5.0) & (np.abs(ballast) > 0.9)
        rate = np.gradient(depth)[under]
        assert np.mean(np.sign(rate) == -np.sign(ballast[under])) > 0.95
