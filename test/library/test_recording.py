"""A recording as arrays, beside what an independent reader finds in it."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import StoragePlugin, Writer

import cocorosim_ros as cocorosim
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store


def independent(bag: Path, topic: str) -> list[Any]:
    """The messages of a topic by the library rosbags."""
    with AnyReader([bag], default_typestore=type_store()) as reader:
        wanted = [connection for connection in reader.connections if connection.topic == topic]
        return [reader.deserialize(data, each.msgtype) for each, _, data in reader.messages(wanted)]


def test_tracks_are_what_rosbags_reads(shipped: Path) -> None:
    """Places to the bit; the heading is that of the quaternion."""
    recording = cocorosim.read_recording(shipped)
    assert recording.robots == tuple(f"lily_{number:02d}" for number in range(1, 6))
    poses = [message.pose for message in independent(shipped / "bag", "/lily_03/pose")]
    track = recording.tracks["lily_03"]
    assert track.position.tolist() == [[pose.position.x, pose.position.y, pose.position.z] for pose in poses]
    yaw = [2.0 * math.atan2(pose.orientation.z, pose.orientation.w) for pose in poses]
    np.testing.assert_allclose(np.cos(track.yaw - yaw), 1.0, rtol=0, atol=1e-14)
    assert track.time[1] == 0.5


@pytest.mark.parametrize(
    ("topic", "column", "unit", "read"),
    [
        ("compass", "heading", "rad", lambda message: message.heading),
        ("pressure", "pressure", "Pa", lambda message: message.fluid_pressure),
        ("imu", "angular_rate_z", "rad/s", lambda message: message.angular_velocity.z),
        ("imu", "specific_force_x", "m/s^2", lambda message: message.linear_acceleration.x),
        ("velocity", "v", "m/s", lambda message: message.twist.linear.y),
        ("velocity", "r", "rad/s", lambda message: message.twist.angular.z),
        ("blss", "up.obstacle_range", "m", lambda message: message.readings[3].obstacle_range),
        ("thruster_command", "right", "1", lambda message: message.command[1]),
    ],
)
def test_readings_are_what_rosbags_reads(
    topic: str, column: str, unit: str, read: Callable[[Any], float], shipped: Path
) -> None:
    """Each column by its name, with its unit, at the stamps of the headers."""
    readings = cocorosim.read_recording(shipped).readings["lily_02"][topic]
    messages = independent(shipped / "bag", f"/lily_02/{topic}")
    stamps = [message.header.stamp.sec * 10**9 + message.header.stamp.nanosec for message in messages]
    assert readings.stamp_ns.tolist() == stamps
    assert readings.column(column).tolist() == [read(message) for message in messages]
    assert dict(zip(readings.columns, readings.units, strict=True))[column] == unit
    assert (readings.robot, readings.topic, readings.unreadable) == ("lily_02", topic, 0)
    with pytest.raises(cocorosim.CocorosimError, match="has no column 'nothing'; its columns are: "):
        readings.column("nothing")


def test_it_knows_what_made_it(shipped: Path) -> None:
    """The scenario as a record that can be simulated again, seed and digest."""
    recording = cocorosim.read_recording(shipped)
    assert recording.scenario is not None
    assert (recording.scenario.name, str(recording.scenario.seed)) == ("five_lilys", recording.metadata["seed"])
    assert recording.digest is not None and len(recording.digest) >= 16
    assert (recording.damage, recording.findings) == ("", ())


def test_damage_is_said(shipped: Path, tmp_path: Path) -> None:
    """Half a file is read as far as it goes."""
    whole = (shipped / "bag" / "bag_0.mcap").read_bytes()
    (tmp_path / "cut.mcap").write_bytes(whole[: len(whole) // 2])
    cut = cocorosim.read_recording(tmp_path / "cut.mcap")
    assert "was not closed" in cut.damage
    assert cut.damage in cut.findings
    assert cut.damage in cut.measure().findings
    assert 0 < len(cut.tracks["lily_01"].stamp_ns) < 240


@pytest.fixture
def foreign(tmp_path: Path) -> Path:
    """Somebody else's recording: a compass of another type, a boat whose actuators change, one message cut short."""
    command = "cocorosim_msgs/msg/ThrusterCommand"
    rows = [({"name": ["left"], "command": [0.5]}, 1), ({"name": ["left", "pump"], "command": [0.25, -1.0]}, 2)]
    with Writer(tmp_path / "foreign", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        heading = writer.add_connection("/boat/compass", "std_msgs/msg/String", typestore=type_store())
        writer.write(heading, 1, serialize(build("std_msgs/msg/String", {"data": "north"})))
        asked = writer.add_connection("/boat/thruster_command", command, typestore=type_store())
        for values, second in rows:
            message = build(command, {"header": {"stamp": {"sec": second, "nanosec": 5}}, **values})
            writer.write(asked, second * 10**9, serialize(message))
        writer.write(asked, 3 * 10**9, serialize(message)[:10])
    return tmp_path / "foreign"


def test_what_others_recorded(foreign: Path) -> None:
    """A column is NaN where a message lacks it; other types and what cannot be read are said."""
    recording = cocorosim.read_recording(foreign)
    assert (recording.robots, recording.scenario, recording.digest) == (("boat",), None, None)
    commands = recording.readings["boat"]["thruster_command"]
    assert commands.columns == ("left", "pump")
    assert commands.stamp_ns.tolist() == [1_000_000_005, 2_000_000_005]
    np.testing.assert_array_equal(commands.values, [[0.5, math.nan], [0.25, -1.0]])
    said = " ".join(recording.findings)
    assert "/boat/compass is of type std_msgs/msg/String instead of cocorosim_msgs/msg/Compass" in said
    assert "/boat/thruster_command: 1 of 3 messages could not be read." in said
    with pytest.raises(cocorosim.CocorosimError, match="holds no poses"):
        recording.measure()


def test_frames_are_long(shipped: Path, foreign: Path) -> None:
    """One row a message, robot by robot; a topic that nobody has gives no row, an unknown one is refused."""
    recording = cocorosim.read_recording(shipped)
    poses = recording.to_frame()
    assert list(poses.columns) == ["stamp_ns", "time", "robot", "x", "y", "z", "yaw"]
    assert len(poses) == 5 * 240
    third = poses[poses["robot"] == "lily_03"]
    assert third["z"].tolist() == recording.tracks["lily_03"].position[:, 2].tolist()
    compass = recording.to_frame("compass")
    assert compass["heading"].tolist()[:240] == recording.readings["lily_01"]["compass"].column("heading").tolist()
    assert recording.to_frame("illuminance").empty
    assert cocorosim.read_recording(foreign).to_frame("thruster_command")["pump"].tolist()[1] == -1.0
    with pytest.raises(cocorosim.CocorosimError, match="'sonar', which is no topic of numbers; choose from pose"):
        recording.to_frame("sonar")


def test_it_is_drawn(shipped: Path, tmp_path: Path) -> None:
    """The picture of `cocorosim metrics --picture`; a file that is there has to be forced."""
    recording = cocorosim.read_recording(shipped)
    file = recording.draw(tmp_path / "shoal.png")
    assert file.read_bytes().startswith(b"\x89PNG")
    with pytest.raises(cocorosim.CocorosimError, match="exists already"):
        recording.draw(file)
    assert recording.draw(str(file), recording.measure(), force=True) == file


def test_it_shows_itself(shipped: Path, foreign: Path, parse: Callable[[str], Any]) -> None:
    """Robots with their poses and topics; what is odd stands below, as text."""
    page = parse(cocorosim.read_recording(shipped)._repr_html_())
    assert {"lily_05", "240", "recording bag"} <= set(page.cells)
    odd = cocorosim.read_recording(foreign)
    assert odd.findings[0] in parse(odd._repr_html_()).cells
    assert "robots 1" in repr(odd)


def test_to_look_at_it_reads_no_message(shipped: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What it shows of itself, large recordings too, is what their summary says."""
    with AnyReader([shipped / "bag"], default_typestore=type_store()) as reader:
        messages = reader.message_count
    recording = cocorosim.read_recording(shipped)
    monkeypatch.setattr(type(recording.bag), "messages", None)
    assert recording.robots[0] == "lily_01"
    assert f"messages {messages}," in repr(recording) and "lily_05" in recording._repr_html_()
    with pytest.raises(TypeError):
        _ = recording.tracks


def test_it_draws_the_tracks_that_were_asked_for(shipped: Path) -> None:
    """A line for each robot, in a notebook."""
    recording = cocorosim.read_recording(shipped)
    assert "<polyline" not in recording._repr_html_()
    assert len(recording.tracks) == recording._repr_html_().count("<polyline")


@pytest.mark.parametrize("name", ["absent", "empty"])
def test_what_is_no_recording(name: str, tmp_path: Path) -> None:
    """One sentence names the path."""
    (tmp_path / "empty").mkdir()
    with pytest.raises(cocorosim.CocorosimError, match=name):
        cocorosim.read_recording(tmp_path / name)
