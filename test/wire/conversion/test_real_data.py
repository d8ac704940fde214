"""Recordings made by others, where they are on this machine: they convert, and mean what the maps' comments say."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

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
