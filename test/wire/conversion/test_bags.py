"""Bags with other topics and types, written by rosbags, which knows nothing of us."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

STORE = get_typestore(Stores.ROS2_JAZZY)
STORE.register(get_types_from_msg("builtin_interfaces/Time when\nfloat32 knots\nuint16[2] pulses", "boat_msgs/msg/Log"))
TYPES = STORE.types
Row = tuple[str, int, Any]


def header(at: int, frame: str = "map") -> Any:
    """A header with a stamp in ns."""
    time = TYPES["builtin_interfaces/msg/Time"](sec=at // 10**9, nanosec=at % 10**9)
    return TYPES["std_msgs/msg/Header"](stamp=time, frame_id=frame)


def vector(*xyz: float) -> Any:
    """A geometry_msgs/Vector3."""
    return TYPES["geometry_msgs/msg/Vector3"](*xyz)


def odometry(at: int, x: float) -> Any:
    """Odometry at x, 2, -3, looking along +y."""
    pose = TYPES["geometry_msgs/msg/Pose"](
        TYPES["geometry_msgs/msg/Point"](x, 2.0, -3.0), TYPES["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.6, 0.8)
    )
    twist = TYPES["geometry_msgs/msg/Twist"](vector(0.1, 0.2, 0.3), vector(0, 0, 0.4))
    zero = np.zeros(36)
    return TYPES["nav_msgs/msg/Odometry"](
        header(at),
        "base",
        TYPES["geometry_msgs/msg/PoseWithCovariance"](pose, zero),
        TYPES["geometry_msgs/msg/TwistWithCovariance"](twist, zero),
    )


def transforms(at: int, *entries: tuple[str, float]) -> Any:
    """A tf message of some child frames at x."""
    turn = TYPES["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
    return TYPES["tf2_msgs/msg/TFMessage"](
        [
            TYPES["geometry_msgs/msg/TransformStamped"](
                header(at), child, TYPES["geometry_msgs/msg/Transform"](vector(x, 0, 0), turn)
            )
            for child, x in entries
        ]
    )


def write(folder: Path, rows: list[Row]) -> Path:
    """A bag of (topic, log time, message)."""
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connections: dict[str, Any] = {}
        for topic, at, message in rows:
            kind = message.__msgtype__
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=STORE)
            writer.write(connections[topic], at, STORE.serialize_cdr(message, kind))
    return folder


@pytest.fixture
def convert_bag(
    tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]
) -> Callable[[str, list[Row]], SimpleNamespace]:
    """Function of (tables, rows): the messages and findings of the conversion."""

    def run(tables: str, rows: list[Row]) -> SimpleNamespace:
        (tmp_path / "map.yaml").write_text(f"name: m\nformat: bag\ntables:\n{tables}")
        done = convert(load_map(tmp_path / "map.yaml"), write(tmp_path / "theirs", rows), tmp_path / "ours")
        return SimpleNamespace(topics=messages(done[0].folder), findings=done[0].conversion.findings)

    return run


def test_odometry_twist_and_thrusters(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> None:
    """The shipped example: pose and velocity by header stamp, two Float64 thrusters joined by recorded time."""
    number = TYPES["std_msgs/msg/Float64"]
    twist = TYPES["geometry_msgs/msg/TwistStamped"](
        header(7, "base"), TYPES["geometry_msgs/msg/Twist"](vector(0.5, -0.1, 0), vector(0, 0, 0.2))
    )
    rows: list[Row] = [
        ("/odometry/filtered", 50, odometry(40, 1.5)),
        ("/odometry/filtered", 60, odometry(30, 1.0)),  # out of order, which bags are
        ("/dvl/twist", 61, twist),
        ("/pressure", 66, TYPES["sensor_msgs/msg/FluidPressure"](header(65, "hull"), 111_000.0, 0.0)),
        ("/thrusters/left/input", 70, number(17.5)),
        ("/thrusters/right/input", 80, number(-14.0)),
        ("/thrusters/left/input", 90, number(0.0)),
    ]
    theirs = write(tmp_path / "theirs", rows)
    convert(load_map(find_config("maps", "odometry_bag")), theirs, tmp_path / "ours")
    topics = messages(tmp_path / "ours")
    poses = topics["/boat/pose"]
    assert [(message.at, message.content.pose.position.x) for message in poses] == [(30, 1.0), (40, 1.5)]
    assert (poses[0].content.pose.orientation.z, poses[0].content.pose.orientation.w) == (0.6, 0.8)
    assert poses[0].content.header.frame_id == "world"
    assert [(each.at, each.content.fluid_pressure) for each in topics["/boat/pressure"]] == [(65, 111_000.0)]
    linear = topics["/boat/ground_velocity"][0].content.twist.linear
    assert (topics["/boat/ground_velocity"][0].at, linear.x, linear.y) == (7, 0.5, -0.1)
    commands = [(message.at, *message.content.command) for message in topics["/boat/thruster_command"]]
    assert commands == [(80, 0.5, -0.5), (90, 0.0, -0.5)]


def test_a_bag_without_a_doppler_log(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> None:
    """Odometry and thrusters alone are enough for the shipped example; what the bag lacks is said."""
    number = TYPES["std_msgs/msg/Float64"]
    rows: list[Row] = [
        ("/odometry/filtered", 30, odometry(30, 1.0)),
        ("/thrusters/left/input", 70, number(17.5)),
        ("/thrusters/right/input", 80, number(-14.0)),
    ]
    (made,) = convert(load_map(find_config("maps", "odometry_bag")), write(tmp_path / "bag", rows), tmp_path / "ours")
    assert sorted(topic for topic in messages(tmp_path / "ours") if topic.startswith("/boat/")) == [
        "/boat/pose", "/boat/thruster_command",
    ]  # fmt: skip
    assert any("/dvl/twist" in finding for finding in made.conversion.findings)


def test_transforms_of_one_frame(convert_bag: Callable[..., SimpleNamespace]) -> None:
    """The transform of a child frame by name; messages without it are left out and counted."""
    path = "transforms[fish/base].transform"
    turn = ", ".join(f"q{axis}: {{column: '{path}.rotation.{axis}'}}" for axis in "xyzw")
    place = ", ".join(f"{axis}: {{column: '{path}.translation.{axis}'}}" for axis in "xyz")
    tables = f"""\
  - topic: /tf
    time: {{stamp: "transforms[fish/base].header.stamp"}}
    robot: fish
    streams:
      pose: {{{place}, {turn}}}
"""
    rows: list[Row] = [
        ("/tf", 1, transforms(11, ("other", 5.0), ("fish/base", 6.0))),
        ("/tf", 2, transforms(12, ("other", 7.0))),
    ]
    result = convert_bag(tables, rows)
    assert [(message.at, message.content.pose.position.x) for message in result.topics["/fish/pose"]] == [(11, 6.0)]
    assert "1 row without a time was left out" in result.findings[0]


def test_a_type_that_only_the_bag_knows(convert_bag: Callable[..., SimpleNamespace]) -> None:
    """The bag's own text of a type is enough; numbers from a list by position."""
    log = TYPES["boat_msgs/msg/Log"]
    tables = """\
  - topic: /log
    time: {stamp: when}
    robot: boat
    streams:
      velocity: {x: {column: knots, scale: 0.514444}}
      thruster_command: {jet: {column: "pulses[1]", unit: us, stop: 1000 us, forward: 2000 us}}
"""
    message = log(header(5).stamp, 2.0, np.array([0, 1250], dtype=np.uint16))
    topics = convert_bag(tables, [("/log", 1, message)]).topics
    assert topics["/boat/velocity"][0].content.twist.linear.x == pytest.approx(1.028888)
    assert (topics["/boat/thruster_command"][0].at, topics["/boat/thruster_command"][0].content.command[0]) == (5, 0.25)


@pytest.mark.parametrize(
    ("topic", "column", "sentence"),
    [
        ("/odo", "pose.pose.position.x", "names /odo, which has no message in theirs; did you mean '/odom'"),
        ("/odom", "pose.pose.position.lat", "no field of /odom of theirs .nav_msgs/msg/Odometry.; did you mean 'pose."),
        ("/odom", "pose.pose", "leads to no single value"),
        ("/odom", "pose..x", "no path like"),
        ("/odom", "child_frame_id", "is no number"),
    ],
)  # fmt: skip
def test_wrong_topics_and_fields(
    convert_bag: Callable[..., SimpleNamespace], topic: str, column: str, sentence: str
) -> None:
    """The sentence names what there is."""
    tables = f"  - {{topic: {topic}, robot: a, streams: {{velocity: {{x: {{column: {column}}}}}}}}}\n"
    with pytest.raises(CocorosimError, match=sentence):
        convert_bag(tables, [("/odom", 1, odometry(1, 0.0))])


def test_joints_report_rotation_and_angle(convert_bag: Callable[..., SimpleNamespace]) -> None:
    """A JointState's elements by name, in SI without a unit; a message that lacks one reports the other."""
    joints = TYPES["sensor_msgs/msg/JointState"]
    both = joints(header(5), ["left", "rudder"], np.array([0.0, 0.25]), np.array([40.0, 0.0]), np.zeros(2))
    alone = joints(header(9), ["left"], np.zeros(1), np.array([50.0]), np.zeros(1))
    tables = (
        "  - topic: /joints\n    robot: boat\n    streams:\n      actuator_feedback:\n"
        "        left: {rotation: {column: 'velocity[left]'}}\n"
        "        rudder: {angle: {column: 'position[rudder]', scale: -1}}\n"
    )
    result = convert_bag(tables, [("/joints", 6, both), ("/joints", 10, alone)])
    first, second = result.topics["/boat/actuator_feedback"]
    assert (first.at, list(first.content.name)) == (5, ["left.rotation", "rudder.angle"])
    assert first.content.value.tolist() == [40.0, -0.25]
    assert second.content.value[0] == 50.0 and np.isnan(second.content.value[1])
