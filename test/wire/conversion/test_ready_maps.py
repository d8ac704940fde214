"""The maps that are shipped for vehicles and simulators of others, each on a small log in that layout."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.typesys import Stores

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.map_file import load_map

from .messages_of_ros import Messages, motion, place

MAPS = sorted(path.stem for path in find_config("maps", "killifish").parent.glob("*.yaml"))
HALF = math.sqrt(0.5)
Converted = Callable[[str, Path], dict[str, list[Any]]]


ROS = Messages(Stores.ROS2_JAZZY)


@pytest.mark.parametrize("name", MAPS)
def test_every_map_loads(name: str) -> None:
    """Each is called like its file and has a format that there is."""
    mapped = load_map(find_config("maps", name))
    assert mapped.name == name and mapped.format in FORMATS


def test_stonefish(converted: Converted, tmp_path: Path) -> None:
    """North-east-down: 1 m north, 2 m east, looking east; forward-right-down velocities."""
    rows = {
        "/girona500/dynamics/odometry": ROS.odometry((1, 2, 3), (0, 0, HALF, HALF), (0.5, 0.1, 0.2), (0, 0, 0.3)),
        "/girona500/controller/thruster_setpoints": ROS.array(0.1, -0.2, 0.3, 1.0, -1.0),
    }
    topics = converted("stonefish", ROS.write(tmp_path / "log", rows))
    assert place(topics["/girona500/pose"][0]) == pytest.approx([2, 1, -3, 0])
    assert motion(topics["/girona500/ground_velocity"][0]) == [0.5, -0.1, -0.2, -0.3]
    assert list(topics["/girona500/thruster_command"][0].content.command) == [0.1, -0.2, 0.3, 1.0, -1.0]


def test_dave(converted: Converted, tmp_path: Path) -> None:
    """Axes of REP 103 as they are; eight thrusts on topics of their own become one command."""
    rows: dict[str, Any] = {
        "/model/rexrov/odometry": ROS.odometry((1, 2, -3), (0, 0, HALF, HALF), (0.5, 0.1, 0.2), (0, 0, 0.3))
    }
    for number in range(1, 9):
        topic = f"/model/rexrov/joint/thruster{number}_joint/cmd_thrust"
        rows[topic] = ROS.make("std_msgs/msg/Float64", 25.0 * number)
    folder = ROS.write(tmp_path / "log", rows)
    (made,) = convert(load_map(find_config("maps", "dave")), folder, tmp_path / "dave")
    assert made.conversion.findings == (
        "rexrov/thruster_command: 7 moments before all actuators are known were left out.",
    )
    streams = {stream.topic: stream.rows.values for stream in made.conversion.streams}
    np.testing.assert_allclose(streams["pose"], [[1, 2, -3, 0, 0, HALF, HALF]])
    np.testing.assert_allclose(streams["ground_velocity"], [[0.5, 0.1, 0.2, 0.3]])
    np.testing.assert_allclose(streams["thruster_command"], [np.arange(1, 9) / 8])


def test_holoocean(converted: Converted, tmp_path: Path) -> None:
    """A world velocity along y of a vehicle that looks along y is forward; forces are fractions of 28.75 N."""
    command = ROS.make(
        "holoocean_interfaces/msg/AgentCommand", ROS.header(0), np.array([28.75, -28.75, 0, 0, 0, 0, 0, 14.375])
    )
    rows = {
        "/holoocean/auv0/DynamicsSensorOdom": ROS.odometry(
            (1, 2, -3), (0, 0, HALF, HALF), (-0.1, 0.5, 0.2), (0.6, 0, 0.3)
        ),
        "/holoocean/command/agent": command,
    }
    topics = converted("holoocean", ROS.write(tmp_path / "log", rows))
    assert place(topics["/auv0/pose"][0]) == pytest.approx([1, 2, -3, math.pi / 2])
    assert motion(topics["/auv0/ground_velocity"][0]) == pytest.approx([0.5, 0.1, 0.2, 0.3], abs=1e-15)
    given = topics["/auv0/thruster_command"][0]
    assert (given.at, list(given.content.command)) == (2 * 10**9, [1, -1, 0, 0, 0, 0, 0, 0.5])


def test_holoocean_when_tilted(converted: Converted, tmp_path: Path) -> None:
    """Any attitude: the body velocity is the world's, turned back by the rotation of the quaternion."""
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_euler("ZYX", [0.7, -0.4, 0.2])
    linear, angular = turn.apply([0.5, -0.1, 0.05]), turn.apply([0.01, 0.02, 0.3])
    odometry = ROS.odometry((0, 0, 0), tuple(turn.as_quat()), tuple(linear), tuple(angular))
    rows = {
        "/holoocean/auv0/DynamicsSensorOdom": odometry,
        "/holoocean/command/agent": ROS.make("holoocean_interfaces/msg/AgentCommand", ROS.header(0), np.zeros(8)),
    }
    topics = converted("holoocean", ROS.write(tmp_path / "log", rows))
    assert motion(topics["/auv0/ground_velocity"][0]) == pytest.approx([0.5, -0.1, 0.05, 0.3], abs=1e-14)


def test_rgblimp(converted: Converted, tmp_path: Path) -> None:
    """1 m north, 2 m east, 3 m down, looking east with the nose up; forces as shares of 0.08 N."""
    head = "t,p_1,p_2,p_3,e_1,e_2,e_3,Fl_series,Fr_series"
    (tmp_path / "data_001.csv").write_text(
        f"{head}\n0,1,2,3,0,0.1,{math.pi / 2},0.02,0.06\n0.05,1,2,3,0,0.1,1.5,0.02,0.06\n"
    )
    topics = converted("rgblimp", tmp_path / "data_001.csv")
    pose = topics["/blimp/pose"][0].content.pose
    assert (pose.position.x, pose.position.y, pose.position.z) == (2, 1, -3)
    turn = pose.orientation  # nose up is a negative turn about the body's left axis
    assert turn.y / turn.w == pytest.approx(-math.tan(0.05)) and abs(turn.z) < 1e-15
    assert list(topics["/blimp/thruster_command"][0].content.command) == pytest.approx([0.25, 0.75])


def test_slocum_glider(converted: Converted, tmp_path: Path) -> None:
    """Pressure of the water beside that of the air, nose up, a ballast of half its range."""
    (tmp_path / "glider_A.csv").write_text(
        "t,pressure_bar,pitch,ballast_cc,density\n0,1,0.4,125,1005\n1,1,0.4,-125,1005\n"
    )
    topics = converted("slocum_glider", tmp_path / "glider_A.csv")
    assert topics["/glider/pressure"][0].content.fluid_pressure == pytest.approx(201325)
    assert topics["/glider/imu"][0].content.orientation.y == pytest.approx(-math.sin(0.2))
    assert [each.content.command[0] for each in topics["/glider/thruster_command"]] == [0.5, -0.5]


def test_tauv_pool(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> None:
    """North-east-down and forward-right-down; a wrench as shares of the platform's five forces."""
    head = "%time,field.header.stamp," + ",".join(
        f"field.{name}.{axis}" for name in ("position", "velocity", "orientation") for axis in "xyz"
    )
    rows = [f"{k + 1},{k},1,2,3,0.5,0.1,0.2,0,0,{math.pi / 2}" for k in (10**9, 2 * 10**9)]
    (tmp_path / "navigation_state_07.csv").write_text("\n".join([head, *rows]) + "\n")
    wrench = "%time," + ",".join(f"field.{name}.{axis}" for name in ("force", "torque") for axis in "xyz")
    (tmp_path / "wrench_07.csv").write_text(f"{wrench}\n1000000000,4,7,-8,-1,-5.5,3\n")
    (made,) = convert(load_map(find_config("maps", "tauv_pool")), tmp_path, tmp_path / "ours")
    topics = messages(made.folder)
    assert place(topics["/auv/pose"][0]) == pytest.approx([2, 1, -3, 0])
    assert motion(topics["/auv/velocity"][0])[:3] == [0.5, -0.1, -0.2]
    command = topics["/auv/thruster_command"][0].content
    force = load_platform("tauv_pool").actuator_limits()[:, 0] * command.command
    wrench_up = force @ load_platform("tauv_pool").actuator_wrenches()
    np.testing.assert_allclose(wrench_up, [4, -7, 8, -3], atol=1e-12)  # forward-left-up


def test_milliampere_ferry(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> None:
    """The middle of a ferry that looks east, 0.983 m north and 0.04 m west of its antenna; orders and reports."""
    trial = tmp_path / "logs" / "crossing"
    trial.mkdir(parents=True)
    stamp = "header_stamp_secs,header_stamp_nsecs"
    (trial / "vectorVS330_fix.csv").write_text(f"{stamp},latitude,longitude\n60,20000000,63.4422,10.4209\n")
    half = math.sqrt(0.5)
    (trial / "vectorVS330_heading.csv").write_text(f"{stamp},quaternion_z,quaternion_w\n60,0,{-half},{-half}\n")
    for number in (1, 2, 3, 4):
        rows = f"1970/01/01 02:01:00.7,{500 * (-1) ** number},90\n1970/01/01 02:01:00.30,0,-180\n"
        (trial / f"actuator_ref_{number}.csv").write_text(f"time,throttle_reference,angle_reference\n{rows}")
        reports = {"azimuth_angle": f"data\n1970/01/01 02:01:00.{number},{30 * number}\n"}
        reports["thruster_motor_state"] = f"motor_speed\n1970/01/01 02:01:00.{10 + number},{-60 * number}\n"
        for kind, column in reports.items():
            (trial / f"actuators_actuator_{number}_{kind}.csv").write_text(f"time,{column}")
    (made,) = convert(load_map(find_config("maps", "milliampere_ferry")), tmp_path / "logs", tmp_path / "ours")
    assert made.conversion.findings == ()
    topics = messages(made.folder)
    assert place(topics["/ferry/pose"][0]) == pytest.approx([49.907 - 0.04, 111.469 + 0.983, 0, 0], abs=1e-6)
    orders = topics["/ferry/thruster_command"]
    assert [each.at for each in orders] == [60_000_000_007, 60_000_000_030]
    assert tuple(orders[0].content.name) == load_platform("milliampere_ferry").actuator_names
    np.testing.assert_allclose(orders[0].content.command, [-0.5, -0.5, 0.5, -0.5, -0.5, -0.5, 0.5, -0.5])
    np.testing.assert_allclose(orders[1].content.command, [0.0, 1.0] * 4)
    feedback = topics["/ferry/actuator_feedback"]
    assert [each.at - 60_000_000_000 for each in feedback] == [1, 2, 3, 4, 11, 12, 13, 14]
    reported = {
        name: value for each in feedback for name, value in zip(each.content.name, each.content.value, strict=True)
    }
    names = ("bow_port", "bow_starboard", "stern_starboard", "stern_port")
    assert reported == pytest.approx(
        {f"{name}_angle.angle": -math.radians(30 * number) for number, name in enumerate(names, start=1)}
        | {f"{name}.rotation": -2 * math.pi * number for number, name in enumerate(names, start=1)}
    )
