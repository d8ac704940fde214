"""The maps that are shipped for vehicles and simulators of others, each on a small log in that layout."""

from __future__ import annotations

import math
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Rosbag1
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.map_file import load_map

MAPS = sorted(path.stem for path in find_config("maps", "killifish").parent.glob("*.yaml"))
OWN_TYPES = {
    "mavros_msgs/msg/RCOut": "std_msgs/Header header\nuint16[] channels",
    "holoocean_interfaces/msg/AgentCommand": "std_msgs/Header header\nfloat64[] command",
}
HALF = math.sqrt(0.5)
Converted = Callable[[str, Path], dict[str, list[Any]]]


@pytest.fixture
def converted(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> Converted:
    """Function of (map, source): the messages of the recording by topic; every line of the map has to be used."""

    def run(name: str, source: Path) -> dict[str, list[Any]]:
        (made,) = convert(load_map(find_config("maps", name)), source, tmp_path / "ours")
        assert made.conversion.findings == ()
        return messages(made.folder)

    return run


class Messages:
    """Makes messages of a release of ROS."""

    def __init__(self, release: Stores) -> None:
        self.store = get_typestore(release)
        for name, text in OWN_TYPES.items():
            self.store.register(get_types_from_msg(text, name))
        self._ros1 = release == Stores.ROS1_NOETIC

    def make(self, name: str, *fields: Any) -> Any:
        """A message of a type by its short name."""
        return self.store.types[name](*fields)

    def header(self, seconds: int) -> Any:
        """A header."""
        stamp = self.make("builtin_interfaces/msg/Time", seconds, 0)
        return self.make("std_msgs/msg/Header", *([0] if self._ros1 else []), stamp, "")

    def vector(self, xyz: tuple[float, float, float]) -> Any:
        """Three numbers."""
        return self.make("geometry_msgs/msg/Vector3", *map(float, xyz))

    def pose(self, place: tuple[float, float, float], turn: tuple[float, float, float, float]) -> Any:
        """A pose."""
        position = self.make("geometry_msgs/msg/Point", *map(float, place))
        return self.make(
            "geometry_msgs/msg/Pose", position, self.make("geometry_msgs/msg/Quaternion", *map(float, turn))
        )

    def odometry(self, place: Any, turn: Any, linear: Any, angular: Any) -> Any:
        """Odometry at 1 s."""
        twist = self.make("geometry_msgs/msg/Twist", self.vector(linear), self.vector(angular))
        zero = np.zeros(36)
        return self.make(
            "nav_msgs/msg/Odometry",
            self.header(1),
            "",
            self.make("geometry_msgs/msg/PoseWithCovariance", self.pose(place, turn), zero),
            self.make("geometry_msgs/msg/TwistWithCovariance", twist, zero),
        )

    def array(self, *numbers: float) -> Any:
        """A list of numbers."""
        layout = self.make("std_msgs/msg/MultiArrayLayout", [], 0)
        return self.make("std_msgs/msg/Float64MultiArray", layout, np.array(numbers))

    def write(self, path: Path, rows: dict[str, Any]) -> Path:
        """A bag with one message on each topic, recorded at 1 s, 2 s, ..."""
        writer = Rosbag1(path) if self._ros1 else Writer(path, version=9, storage_plugin=StoragePlugin.MCAP)
        serialize = self.store.serialize_ros1 if self._ros1 else self.store.serialize_cdr
        with writer as opened:
            for second, (topic, message) in enumerate(rows.items(), start=1):
                kind = message.__msgtype__
                connection = opened.add_connection(topic, kind, typestore=self.store)
                opened.write(connection, second * 10**9, serialize(message, kind))
        return path


ROS = Messages(Stores.ROS2_JAZZY)


def place(message: Any) -> list[float]:
    """Position and yaw of a pose."""
    pose = message.content.pose
    x, y, z, w = (getattr(pose.orientation, axis) for axis in "xyzw")
    yaw = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return [pose.position.x, pose.position.y, pose.position.z, yaw]


def motion(message: Any) -> list[float]:
    """Velocity and yaw rate."""
    twist = message.content.twist
    return [twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.z]


@pytest.mark.parametrize("name", MAPS)
def test_every_map_loads(name: str) -> None:
    """Each is called like its file and has a format that there is."""
    mapped = load_map(find_config("maps", name))
    assert mapped.name == name and mapped.format in FORMATS


@pytest.mark.parametrize("release", [Stores.ROS2_JAZZY, Stores.ROS1_NOETIC])
def test_mavros(release: Stores, converted: Converted, tmp_path: Path) -> None:
    """Pose, attitude and pulses, from ROS 2 and from ROS 1."""
    ros = Messages(release)
    turn, zero = (0.0, 0.0, HALF, HALF), np.zeros(9)
    imu = ros.make(
        "sensor_msgs/msg/Imu",
        *(ros.header(2), ros.make("geometry_msgs/msg/Quaternion", *turn), zero),
        *(ros.vector((0.1, 0.2, 0.3)), zero, ros.vector((1, 2, 9.81)), zero),
    )
    pulses = ros.make("mavros_msgs/msg/RCOut", ros.header(3), np.array([1500, 1900, 1100, 1600, 1400, 1500], np.uint16))
    pose = ros.make("geometry_msgs/msg/PoseStamped", ros.header(1), ros.pose((1, 2, -3), turn))
    rows = {"/mavros/local_position/pose": pose, "/mavros/imu/data": imu, "/mavros/rc/out": pulses}
    topics = converted("mavros_ardusub", ros.write(tmp_path / "log.bag", rows))
    assert place(topics["/rov/pose"][0]) == pytest.approx([1, 2, -3, math.pi / 2])
    reading = topics["/rov/imu"][0].content
    assert (reading.angular_velocity.z, reading.linear_acceleration.z) == (0.3, 9.81)
    assert (reading.orientation.w, reading.orientation_covariance[0]) == (HALF, 0.0)
    assert list(topics["/rov/thruster_command"][0].content.command) == pytest.approx([0, 1, -1, 0.25, -0.25, 0])


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


@pytest.fixture
def logs() -> SimpleNamespace:
    """What writes DataFlash and MAVLink byte by byte."""
    folder = str(Path(__file__).parents[2] / "contracts")
    if folder not in sys.path:
        sys.path.append(folder)
    import logs_by_format

    return SimpleNamespace(**vars(logs_by_format))


def dataflash(logs: SimpleNamespace) -> bytes:
    """XKF1 and IMU in two instances each, and RCOU."""
    kinds = {
        1: ("XKF1", "QBccCfff", "TimeUS,C,Roll,Pitch,Yaw,PN,PE,PD"),
        2: ("IMU", "QBffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ"),
        3: ("RCOU", "QHHHHHH", "TimeUS,C1,C2,C3,C4,C5,C6"),
        4: ("FMTU", "QBNN", "TimeUS,FmtType,UnitIds,MultIds"),
    }
    sizes = {"Q": 8, "B": 1, "c": 2, "C": 2, "f": 4, "H": 2, "N": 16}
    formats = (b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns")
    parts = [struct.pack("<3sBB4s16s64s", b"\xa3\x95\x80", 0x80, 89, *formats)]
    for kind, (name, letters, columns) in kinds.items():
        length = 3 + sum(sizes[letter] for letter in letters)
        texts = (text.encode() for text in (name, letters, columns))
        parts.append(struct.pack("<3sBB4s16s64s", b"\xa3\x95\x80", kind, length, *texts))
    for kind in (1, 2):
        parts.append(struct.pack("<3sQB16s16s", b"\xa3\x95\x04", 0, kind, b"s#------", b"F-------"))
    for core in (0, 1):
        numbers = (1000, -2000, 9000, 1.0, 2.0 + core, 3.0)  # hundredths of a degree, then m
        parts.append(struct.pack("<3sQBhhHfff", b"\xa3\x95\x01", 5_000_000, core, *numbers))
        parts.append(struct.pack("<3sQBffffff", b"\xa3\x95\x02", 5_000_001, core, 0.5, 0.25, 0.125, 1.0, 2.0, -9.75))
    parts.append(struct.pack("<3sQ6H", b"\xa3\x95\x03", 5_000_002, 1500, 1900, 1100, 1600, 1400, 1500))
    return b"".join(parts)


def test_ardusub_dataflash(logs: SimpleNamespace, converted: Converted, tmp_path: Path) -> None:
    """The first instances, degrees in hundredths, north-east-down."""
    (tmp_path / "log.BIN").write_bytes(dataflash(logs))
    topics = converted("ardusub_dataflash", tmp_path / "log.BIN")
    assert place(topics["/rov/pose"][0]) == pytest.approx([2, 1, -3, 0], abs=1e-12)
    assert topics["/rov/pose"][0].at == 5_000_000_000
    reading = topics["/rov/imu"][0].content
    assert (reading.angular_velocity.y, reading.linear_acceleration.z) == (-0.25, 9.75)
    assert list(topics["/rov/thruster_command"][0].content.command) == pytest.approx([0, 1, -1, 0.25, -0.25, 0])


def test_dataflash_as_another_reader_has_it(logs: SimpleNamespace, tmp_path: Path) -> None:
    """pymavlink reads the same numbers from the same bytes."""
    from pymavlink.DFReader import DFReader_binary

    from cocorosim_ros.scenario.reading.entry import Entry
    from cocorosim_ros.wire.conversion.formats.dataflash import DataFlashLog

    file = tmp_path / "log.bin"
    file.write_bytes(dataflash(logs))
    theirs = DFReader_binary(str(file))
    theirs.filehandle.close()
    ours = DataFlashLog(file)
    for topic, count in (("XKF1", 2), ("IMU", 2), ("RCOU", 1)):
        theirs.rewind()
        found = [theirs.recv_match(type=topic) for _ in range(count)]
        for core, message in enumerate(found):
            rows = ours.rows(topic if count == 1 else f"{topic}[{core}]", Entry("", "map.yaml", 1, "topic"))
            for column in message.fmt.columns:
                place = Entry(column, "map.yaml", 1, "column")
                assert rows.numbers(place).tolist() == [pytest.approx(float(getattr(message, column)), rel=1e-12)]


def test_instances_have_to_be_told_apart(logs: SimpleNamespace, tmp_path: Path) -> None:
    """Two lanes of an estimate are not one; the sentence offers both."""
    from cocorosim_ros.foundation.errors import CocorosimError
    from cocorosim_ros.scenario.reading.entry import Entry
    from cocorosim_ros.wire.conversion.formats.dataflash import DataFlashLog

    (tmp_path / "log.bin").write_bytes(dataflash(logs))
    log = DataFlashLog(tmp_path / "log.bin")
    for topic, sentence in (
        ("XKF1", r"names XKF1, of which log.bin has several; write XKF1.0. or XKF1.1."),
        ("XKF1[2]", r"names XKF1.2., which log.bin does not have; write XKF1.0. or XKF1.1."),
    ):
        with pytest.raises(CocorosimError, match=sentence):
            log.rows(topic, Entry(topic, "map.yaml", 1, "topic"))


def test_ardusub_tlog(logs: SimpleNamespace, converted: Converted, tmp_path: Path) -> None:
    """Position with the attitude beside it, pressure in hPa, pulses, by the vehicle's own time."""
    parts = [
        logs.local_position(7000, 1.0, 2.0, 3.0, 0, 0, 0),
        logs.mavlink(30, struct.pack("<I6f", 7100, 0, 0, math.pi / 2, 0, 0, 0), 39),
        logs.mavlink(137, struct.pack("<Iffh", 7200, 1307.5, 0.0, 2000), 195),
        logs.mavlink(36, struct.pack("<I8HB", 7_300_000, 1500, 1900, 1100, 1600, 1400, 1500, 0, 0, 0), 222),
    ]
    content = b"".join(struct.pack(">Q", 10**15 + row) + part for row, part in enumerate(parts))
    (tmp_path / "log.tlog").write_bytes(content)
    topics = converted("ardusub_tlog", tmp_path / "log.tlog")
    assert topics["/rov/pose"][0].at == 7_000_000_000
    assert place(topics["/rov/pose"][0]) == pytest.approx([2, 1, -3, 0], abs=1e-6)
    assert topics["/rov/pressure"][0].content.fluid_pressure == pytest.approx(130750)
    commands = topics["/rov/thruster_command"][0]
    assert commands.at == 7_300_000_000
    assert list(commands.content.command) == pytest.approx([0, 1, -1, 0.25, -0.25, 0])


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
    """The middle of a ferry that looks east, 0.983 m north and 0.04 m west of its antenna; orders."""
    trial = tmp_path / "logs" / "crossing"
    trial.mkdir(parents=True)
    stamp = "header_stamp_secs,header_stamp_nsecs"
    (trial / "vectorVS330_fix.csv").write_text(f"{stamp},latitude,longitude\n60,20000000,63.4422,10.4209\n")
    half = math.sqrt(0.5)
    (trial / "vectorVS330_heading.csv").write_text(f"{stamp},quaternion_z,quaternion_w\n60,0,{-half},{-half}\n")
    for number in (1, 2, 3, 4):
        rows = f"1970/01/01 02:01:00.7,{500 * (-1) ** number},90\n1970/01/01 02:01:00.30,0,-180\n"
        (trial / f"actuator_ref_{number}.csv").write_text(f"time,throttle_reference,angle_reference\n{rows}")
    (made,) = convert(load_map(find_config("maps", "milliampere_ferry")), tmp_path / "logs", tmp_path / "ours")
    assert made.conversion.findings == ()
    topics = messages(made.folder)
    assert place(topics["/ferry/pose"][0]) == pytest.approx([49.907 - 0.04, 111.469 + 0.983, 0, 0], abs=1e-6)
    orders = topics["/ferry/thruster_command"]
    assert [each.at for each in orders] == [60_000_000_007, 60_000_000_030]
    assert tuple(orders[0].content.name) == load_platform("milliampere_ferry").actuator_names
    np.testing.assert_allclose(orders[0].content.command, [-0.5, -0.5, 0.5, -0.5, -0.5, -0.5, 0.5, -0.5])
    np.testing.assert_allclose(orders[1].content.command, [0.0, 1.0] * 4)
