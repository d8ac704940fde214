"""Trials of the ferry, where they are on this machine: what its map's comments say of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.signal import savgol_filter

from cocorosim_ros.diagnosis.evidence.following.reports import actuator_reports
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.bags.tracks import RecordedTrack, read_poses
from cocorosim_ros.wire.conversion.assembly import Stream
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

DATA = Path(__file__).resolve().parents[4] / "shared" / "data" / "milliampere_ferry"
STEP = 0.05  # s

pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the recordings of others are not on this machine")


@pytest.fixture(scope="module")
def crossing(tmp_path_factory: pytest.TempPathFactory) -> tuple[RecordedTrack, Stream]:
    """Poses and orders of the trial that goes from place to place."""
    made = convert(
        load_map(find_config("maps", "milliampere_ferry")),
        DATA / "nlp1" / "vectorVS330_fix.csv",
        tmp_path_factory.mktemp("ferry") / "bag",
    )[0]
    orders = next(stream for stream in made.conversion.streams if stream.topic == "thruster_command")
    return read_poses(made.folder)["ferry"], orders


def test_places_are_those_of_the_estimate(crossing: tuple[RecordedTrack, Stream]) -> None:
    """The antenna moved to the middle is a fixed shift from the vessel's own estimate of north, east and yaw."""
    track, _ = crossing
    names = ("header_stamp_secs", "header_stamp_nsecs", "pose_position_x", "pose_position_y",
             "pose_orientation_x", "pose_orientation_y", "pose_orientation_z", "pose_orientation_w")  # fmt: skip
    log = np.genfromtxt(DATA / "nlp1" / "navigation_nav_estimate.csv", delimiter=",", names=True, usecols=names)
    moment = log["header_stamp_secs"] + log["header_stamp_nsecs"] * 1e-9
    when = track.stamp_ns * 1e-9
    east, north = (np.interp(moment, when, track.position[:, axis]) for axis in (0, 1))
    x, y, z, w = (log[f"pose_orientation_{axis}"] for axis in "xyzw")
    heading = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y**2 + z**2))
    turned = np.interp(moment, when, np.unwrap(track.yaw)) - (np.pi / 2 - heading)
    assert np.std(log["pose_position_x"] - north) < 0.1  # m; without the antenna's arm 0.3
    assert np.std(log["pose_position_y"] - east) < 0.1  # without it 0.15
    assert abs(np.median(np.angle(np.exp(1j * turned)))) < 0.02


def test_orders_push_and_turn_it_as_its_platform_says(crossing: tuple[RecordedTrack, Stream]) -> None:
    """Accelerations ahead, to the left and about the vertical go with forces and torque of the orders."""
    track, orders = crossing
    platform = load_platform("milliampere_ferry")
    when = np.arange(track.stamp_ns[0] * 1e-9 + 5.0, track.stamp_ns[-1] * 1e-9 - 5.0, STEP)
    latest = np.searchsorted(orders.stamp_ns * 1e-9, when - 0.4, side="right") - 1  # angles follow late
    command = orders.rows.values[latest]
    thrust, angle = np.sign(command[:, 0::2]) * command[:, 0::2] ** 2, np.pi * command[:, 1::2]
    parts = np.empty_like(command)
    parts[:, 0::2], parts[:, 1::2] = thrust * np.cos(angle), thrust * np.sin(angle)
    wrench = parts @ platform.actuator_wrenches()
    yaw = np.interp(when, track.stamp_ns * 1e-9, np.unwrap(track.yaw))
    east, north = (_second(np.interp(when, track.stamp_ns * 1e-9, track.position[:, axis])) for axis in (0, 1))
    ahead, left = east * np.cos(yaw) + north * np.sin(yaw), north * np.cos(yaw) - east * np.sin(yaw)
    for column, gained in ((0, ahead), (1, left), (3, _second(yaw))):
        assert np.corrcoef(savgol_filter(wrench[:, column], 61, 3), gained)[0, 1] > 0.6


def test_angles_follow_orders_by_two_thirds_to_four_fifths_of_a_second(tmp_path: Path) -> None:
    """As the map's comments have it: 0.65 to 0.8 s, to the angle that is ordered; by the recordings alone."""
    source = DATA / "maneuvering1" / "vectorVS330_fix.csv"
    bag = convert(load_map(find_config("maps", "milliampere_ferry")), source, tmp_path / "bag")[0].folder
    reports = actuator_reports(gather_evidence([bag], load_platform("milliampere_ferry")))
    angles = {each.actuator: each.numbers for each in reports if each.quantity == "angle"}
    assert list(angles) == [
        f"{place}_angle" for place in ("bow_port", "bow_starboard", "stern_starboard", "stern_port")
    ]
    for numbers in angles.values():
        assert 0.65 < numbers["lateness"].value < 0.8
        assert numbers["gain"].holds(1.0) and numbers["lateness"].high - numbers["lateness"].low < 0.5
    motors = {each.actuator: each.numbers for each in reports if each.quantity == "rotation"}
    # 1000 rpm at full command, of which bow motors report a twentieth less; the motors report later than a second.
    assert all(numbers["gain"].value == pytest.approx(104.7, rel=0.2) for numbers in motors.values() if numbers)
    assert all(numbers["lateness"].value > 1.0 for numbers in motors.values() if numbers)


def _second(path: Floats) -> Floats:
    """The second derivative over 3 s."""
    return np.asarray(savgol_filter(path, 61, 3, deriv=2, delta=STEP))
