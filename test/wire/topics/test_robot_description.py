"""URDF and fixed frames of every platform, read by urdf-parser-py, against the numbers of its file."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from urdf_parser_py.urdf import URDF, Box, Cylinder, Link, Sphere

from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.wire.cdr.type_store import deserialize
from cocorosim_ros.wire.topics.colours import Rgb
from cocorosim_ros.wire.topics.robot_description import description_message, static_frames, urdf

PLATFORMS = sorted(path.stem for path in (Path(__file__).parents[3] / "config/platforms").glob("*.yaml"))
COLOUR = Rgb(0.9, 0.2, 0.1)


def rotation(roll: float, pitch: float, yaw: float) -> np.ndarray:
    """The matrix of URDF's fixed-axis angles: about x, then y, then z."""
    (a, b, c), (d, e, f) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    about_x = np.array([[1, 0, 0], [0, a, -d], [0, d, a]])
    about_y = np.array([[b, 0, e], [0, 1, 0], [-e, 0, b]])
    about_z = np.array([[c, -f, 0], [f, c, 0], [0, 0, 1]])
    return np.asarray(about_z @ about_y @ about_x)


def of_quaternion(x: float, y: float, z: float, w: float) -> np.ndarray:
    """Where a quaternion of length one turns the x axis."""
    assert math.isclose(x * x + y * y + z * z + w * w, 1.0)
    return np.array([1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)])


@pytest.fixture(params=PLATFORMS)
def platform(request: pytest.FixtureRequest) -> Platform:
    """Every shipped platform."""
    return load_platform(request.param)


@pytest.fixture
def robot(platform: Platform) -> URDF:
    """Its description as another library understands it."""
    return URDF.from_xml_string(urdf("fish_07", platform, COLOUR).encode())


def link(robot: URDF, name: str) -> Link:
    """The link of that name."""
    return next(each for each in robot.links if each.name == name)


def test_body(platform: Platform, robot: URDF) -> None:
    """Mass, yaw inertia and hull are those of the file; the root is the frame that /tf moves."""
    body = link(robot, robot.get_root())
    assert (robot.name, body.name) == ("fish_07", "fish_07/base_link")
    assert body.inertial.mass == platform.mass
    assert body.inertial.inertia.izz == platform.yaw_inertia
    moments = body.inertial.inertia.ixx, body.inertial.inertia.iyy
    assert min(moments) > 0.0
    hull = [platform.hull.length, platform.hull.width, platform.hull.height]
    box = next(visual.geometry for visual in body.visuals if isinstance(visual.geometry, Box))
    assert box.size == hull
    assert body.collision.geometry.size == hull


def test_thrusters(platform: Platform, robot: URDF) -> None:
    """Each stands where the file says, with its x axis along its push; its cylinder lies along that axis."""
    thrusters = [each for each in platform.actuators if isinstance(each, Thruster)]
    for each in thrusters:
        joint = next(j for j in robot.joints if j.child == f"fish_07/thruster_{each.name}")
        assert (joint.type, joint.parent) == ("fixed", "fish_07/base_link")
        assert tuple(joint.origin.xyz) == each.position
        assert rotation(*joint.origin.rpy)[:, 0] == pytest.approx(each.direction, abs=1e-12)
        visual = link(robot, joint.child).visual
        assert isinstance(visual.geometry, Cylinder)
        assert rotation(*visual.origin.rpy)[:, 2] == pytest.approx([1, 0, 0], abs=1e-12)
    assert sum("/thruster_" in each.name for each in robot.links) == len(thrusters)


def test_sensors(platform: Platform, robot: URDF) -> None:
    """The x axis of each that looks in a direction is that direction; its window lies on the hull."""
    sensors = [*(("blss", each) for each in platform.sensors.blss)]
    sensors += [("obstacles", each) for each in platform.sensors.obstacles or ()]
    half = np.array([platform.hull.length, platform.hull.width, platform.hull.height]) / 2
    for kind, each in sensors:
        joint = next(j for j in robot.joints if j.child == f"fish_07/{kind}_{each.name}")
        turn, level = rotation(*joint.origin.rpy), math.cos(each.elevation)
        axis = [level * math.cos(each.azimuth), level * math.sin(each.azimuth), math.sin(each.elevation)]
        assert turn[:, 0] == pytest.approx(axis, abs=1e-12)
        window = link(robot, joint.child).visual
        assert isinstance(window.geometry, Sphere)
        assert np.max(np.abs(turn @ np.array(window.origin.xyz)) / half) == pytest.approx(1.0)
    names = [each.name for each in robot.links if "/blss_" in each.name or "/obstacles_" in each.name]
    assert len(names) == len(sensors)


def test_frames_are_those_of_the_description(platform: Platform, robot: URDF) -> None:
    """/tf_static has one transform for each joint, with the same place and the same x axis."""
    transforms = deserialize("tf2_msgs/msg/TFMessage", static_frames({"fish_07": platform})).transforms
    assert [each.child_frame_id for each in transforms] == [joint.child for joint in robot.joints]
    for each, joint in zip(transforms, robot.joints, strict=True):
        place, turn = each.transform.translation, each.transform.rotation
        assert each.header.frame_id == joint.parent
        assert [place.x, place.y, place.z] == list(joint.origin.xyz)
        expected = rotation(*joint.origin.rpy)[:, 0]
        assert of_quaternion(turn.x, turn.y, turn.z, turn.w) == pytest.approx(expected, abs=1e-12)


def test_the_message_holds_the_text() -> None:
    """`robot_description` is a std_msgs/String of the description; words of a file cannot break its XML."""
    lily = load_platform("lily")
    data = description_message("fish_07", lily, COLOUR)
    assert deserialize("std_msgs/msg/String", data).data == urdf("fish_07", lily, COLOUR)
