"""The maps of ArduSub vehicles, each on small logs of a vehicle that knows its place and of one that does not."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.typesys import Stores

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.conversion import Conversion, convert
from cocorosim_ros.wire.conversion.formats.dataflash import DataFlashLog
from cocorosim_ros.wire.conversion.map_file import load_map

from .messages_of_ros import Messages, place

Converted = Callable[[str, Path], dict[str, list[Any]]]
HALF = math.sqrt(0.5)
NORTH = (0.0, 0.0, HALF, HALF)  # x, y, z, w of a vehicle that looks along y
PULSES = (1500, 1900, 1100, 1600, 1400, 1500)
SHARES = [0, 1, -1, 0.25, -0.25, 0]
FRESH = 9810.0  # Pa/m: fresh water of 1000 kg/m^3 under 9.81 m/s^2, by which depths are kept as pressures
FLAGS = {"with a place": 831, "without": 165}  # XKF4.SS: 831 has the flags 8 and 16, 165 has 128 and neither of them


def made(name: str, source: Path) -> Conversion:
    """What comes of a log, with its remarks."""
    (done,) = convert(load_map(find_config("maps", name)), source, source.parent / "made")
    return done.conversion


def numbers(conversion: Conversion, topic: str) -> list[float]:
    """The first message of a topic."""
    (stream,) = (each for each in conversion.streams if each.topic == topic)
    return [float(number) for number in stream.rows.values[0]]


def topics_of(conversion: Conversion) -> set[str]:
    """The topics that were made."""
    return {stream.topic for stream in conversion.streams}


# MAVROS


def mavros(ros: Messages, turn: Sequence[float]) -> dict[str, Any]:
    """All topics of the map by name, of a vehicle 3 m deep."""
    zero = np.zeros(9)
    attitude = ros.make("geometry_msgs/msg/Quaternion", *turn)
    rates = (ros.vector((0.1, 0.2, 0.3)), zero, ros.vector((1, 2, 9.81)), zero)
    return {
        "/mavros/local_position/pose": ros.make(
            "geometry_msgs/msg/PoseStamped", ros.header(1), ros.pose((1, 2, -3), NORTH)
        ),
        "/mavros/imu/data": ros.make("sensor_msgs/msg/Imu", ros.header(2), attitude, zero, *rates),
        "/mavros/rc/out": ros.make("mavros_msgs/msg/RCOut", ros.header(3), np.array(PULSES, np.uint16)),
        "/mavros/global_position/rel_alt": ros.make("std_msgs/msg/Float64", -3.0),
        "/mavros/global_position/compass_hdg": ros.make("std_msgs/msg/Float64", 120.0),
        "/mavros/vfr_hud": ros.make("mavros_msgs/msg/VfrHud", ros.header(6), 0.0, 0.0, 120, 0.0, -2.5, 0.0),
    }


@pytest.mark.parametrize("release", [Stores.ROS2_JAZZY, Stores.ROS1_NOETIC])
def test_mavros_with_a_place(release: Stores, converted: Converted, tmp_path: Path) -> None:
    """Pose, attitude and pulses, from ROS 2 and from ROS 1; what the pose tells is not told a second time."""
    ros = Messages(release)
    topics = converted("mavros_ardusub", ros.write(tmp_path / "log.bag", mavros(ros, NORTH)))
    assert place(topics["/rov/pose"][0]) == pytest.approx([1, 2, -3, math.pi / 2])
    reading = topics["/rov/imu"][0].content
    assert (reading.angular_velocity.z, reading.linear_acceleration.z) == (0.3, 9.81)
    assert (reading.orientation.w, reading.orientation_covariance[0]) == (HALF, 0.0)
    assert list(topics["/rov/thruster_command"][0].content.command) == pytest.approx(SHARES)
    assert topics.keys() == {"/rov/pose", "/rov/imu", "/rov/thruster_command"}


@pytest.mark.parametrize("release", [Stores.ROS2_JAZZY, Stores.ROS1_NOETIC])
def test_mavros_without_a_place(release: Stores, tmp_path: Path) -> None:
    """The heading is the yaw of the attitude, whatever roll and pitch are; the depth is that below home."""
    from scipy.spatial.transform import Rotation

    ros = Messages(release)
    rows = mavros(ros, Rotation.from_euler("ZYX", [2.5, -0.4, 0.2]).as_quat())
    del rows["/mavros/local_position/pose"]
    found = made("mavros_ardusub", ros.write(tmp_path / "log.bag", rows))
    assert topics_of(found) == {"compass", "pressure", "imu", "thruster_command"}
    assert numbers(found, "compass") == [pytest.approx(2.5, abs=1e-12)]
    assert numbers(found, "pressure") == [pytest.approx(101325 + 3 * FRESH)]
    assert numbers(found, "thruster_command") == pytest.approx(SHARES)
    assert found.findings == (
        "The log lacks /mavros/local_position/pose (for pose), which the map calls optional; what else the map takes "
        "from it is there.",
    )


def test_mavros_with_the_display_alone(tmp_path: Path) -> None:
    """A bearing of 120 degrees is 30 degrees clockwise of east; an altitude of -2.5 m is a depth."""
    ros = Messages(Stores.ROS2_JAZZY)
    rows = mavros(ros, NORTH)
    for topic in ("/mavros/local_position/pose", "/mavros/imu/data", "/mavros/global_position/rel_alt"):
        del rows[topic]
    found = made("mavros_ardusub", ros.write(tmp_path / "log", rows))
    assert numbers(found, "compass") == [pytest.approx(-math.pi / 6)]
    assert numbers(found, "pressure") == [pytest.approx(101325 + 2.5 * FRESH)]
    assert "/mavros/imu/data (for imu and compass)" in found.findings[0]


def test_mavros_without_any_motion(tmp_path: Path) -> None:
    """Commands alone are no recording of a motion, which is said, and nothing is left behind."""
    ros = Messages(Stores.ROS2_JAZZY)
    source = ros.write(tmp_path / "log", {"/mavros/rc/out": mavros(ros, NORTH)["/mavros/rc/out"]})
    sentence = r"the log lacks /mavros/local_position/pose .*without any of these nothing shows how the vehicle moved"
    with pytest.raises(CocorosimError, match=sentence):
        made("mavros_ardusub", source)
    assert not (tmp_path / "made").exists()


def test_mavros_without_commands(tmp_path: Path) -> None:
    """What is not optional has to be there."""
    ros = Messages(Stores.ROS2_JAZZY)
    rows = mavros(ros, NORTH)
    del rows["/mavros/rc/out"]
    with pytest.raises(CocorosimError, match=r"names /mavros/rc/out, which has no message in log"):
        made("mavros_ardusub", ros.write(tmp_path / "log", rows))


# DataFlash

KINDS = {
    1: ("XKF1", "QBccCfff", "TimeUS,C,Roll,Pitch,Yaw,PN,PE,PD"),
    2: ("IMU", "QBffffff", "TimeUS,I,GyrX,GyrY,GyrZ,AccX,AccY,AccZ"),
    3: ("RCOU", "QHHHHHH", "TimeUS,C1,C2,C3,C4,C5,C6"),
    4: ("FMTU", "QBNN", "TimeUS,FmtType,UnitIds,MultIds"),
    5: ("XKF4", "QBI", "TimeUS,C,SS"),
    6: ("ATT", "QccC", "TimeUS,Roll,Pitch,Yaw"),
    7: ("BARO", "QBffI", "TimeUS,I,Alt,Press,SMS"),
    8: ("CTUN", "Qff", "TimeUS,Alt,BAlt"),
}
CODES = {"Q": "Q", "B": "B", "c": "h", "C": "H", "f": "f", "H": "H", "I": "I", "N": "16s"}
INSTANCES = (1, 2, 5, 7)


def dataflash(flags: int, without: Sequence[str] = ()) -> bytes:
    """Kinds of messages that are no other's, those with instances twice, without some (`BARO[1]`, `ATT`)."""
    formats = (b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns")
    parts = [struct.pack("<3sBB4s16s64s", b"\xa3\x95\x80", 0x80, 89, *formats)]
    for kind, (name, letters, columns) in KINDS.items():
        length = 3 + struct.calcsize("<" + "".join(CODES[letter] for letter in letters))
        texts = (text.encode() for text in (name, letters, columns))
        parts.append(struct.pack("<3sBB4s16s64s", b"\xa3\x95\x80", kind, length, *texts))
    parts += [_message(4, 0, kind, b"s#------", b"F-------") for kind in INSTANCES]
    for core in (0, 1):
        # Hundredths of a degree, then m.
        parts.append(_message(1, 5_000_000, core, 1000, -2000, 9000, 1.0, 2.0 + core, 3.0))
        parts.append(_message(5, 5_000_000, core, flags))
        parts.append(_message(2, 5_000_001, core, 0.5, 0.25, 0.125, 1.0, 2.0, -9.75))
    parts.append(_message(6, 5_010_000, 1000, -2000, 12_000))
    parts += [_message(7, 5_020_000, 0, 0.5, 100_000.0, 5015), _message(7, 5_020_000, 1, -3.0, 131_000.0, 5016)]
    parts.append(_message(8, 5_030_000, -2.75, -3.0))
    parts.append(_message(3, 5_000_002, *PULSES))
    left_out = [_beginning(name) for name in without]
    return b"".join(part for part in parts if not any(_is(part, kind, core) for kind, core in left_out))


def _message(kind: int, *cells: Any) -> bytes:
    return struct.pack("<3s" + "".join(CODES[letter] for letter in KINDS[kind][1]), bytes([0xA3, 0x95, kind]), *cells)


def _beginning(name: str) -> tuple[int, int | None]:
    """The number of a kind, and of the instance."""
    bare, _, instance = name.partition("[")
    kind = next(number for number, (told, _, _) in KINDS.items() if told == bare)
    return kind, int(instance[:-1]) if instance else None


def _is(part: bytes, kind: int, instance: int | None) -> bool:
    return part[2] == kind and (instance is None or part[11] == instance)


def test_dataflash_with_a_place(converted: Converted, tmp_path: Path) -> None:
    """The first instances, degrees in hundredths, north-east-down; the second barometer at the time of its sample."""
    (tmp_path / "log.BIN").write_bytes(dataflash(FLAGS["with a place"]))
    topics = converted("ardusub_dataflash", tmp_path / "log.BIN")
    assert topics.keys() == {f"/rov/{topic}" for topic in ("pose", "imu", "pressure", "thruster_command")}
    assert place(topics["/rov/pose"][0]) == pytest.approx([2, 1, -3, 0], abs=1e-12)
    assert topics["/rov/pose"][0].at == 5_000_000_000
    reading = topics["/rov/imu"][0].content
    assert (reading.angular_velocity.y, reading.linear_acceleration.z) == (-0.25, 9.75)
    (pressure,) = topics["/rov/pressure"]
    assert (pressure.at, pressure.content.fluid_pressure) == (5_016_000_000, 131_000)
    assert list(topics["/rov/thruster_command"][0].content.command) == pytest.approx(SHARES)


@pytest.mark.parametrize("without", [(), ("XKF1",), ("XKF4",), ("XKF1[0]",)])
def test_dataflash_without_a_place(without: Sequence[str], tmp_path: Path) -> None:
    """A place that stands still since nothing shows it is none: heading, attitude and depth remain."""
    from scipy.spatial.transform import Rotation

    (tmp_path / "log.BIN").write_bytes(dataflash(FLAGS["without"], without))
    found = made("ardusub_dataflash", tmp_path / "log.BIN")
    assert topics_of(found) == {"compass", "pressure", "imu", "thruster_command"}
    assert numbers(found, "compass") == [pytest.approx(-math.pi / 6)]  # 120 degrees clockwise from north
    assert numbers(found, "pressure") == [131_000]
    *turn, x, y, z, ahead, left, up = numbers(found, "imu")
    # Pitch up is a negative turn about the body's left axis.
    angles = Rotation.from_quat(turn).as_euler("ZYX", degrees=True)
    assert list(angles) == pytest.approx([-30, 20, 10])
    assert [x, y, z, ahead, left, up] == [0.5, -0.25, -0.125, 1.0, -2.0, 9.75]
    told = f"The log lacks {without[0].partition('[')[0]}[0] (for pose)" if without else "no usable row, so there is no"
    assert any(told in sentence for sentence in found.findings)


@pytest.mark.parametrize("without", ["BARO[1]", "BARO"])
def test_dataflash_without_the_sensor_in_the_water(without: str, tmp_path: Path) -> None:
    """The height by the sensor that the autopilot goes by, -3 m, is the depth, and not that of its estimate."""
    (tmp_path / "log.BIN").write_bytes(dataflash(FLAGS["without"], [without]))
    found = made("ardusub_dataflash", tmp_path / "log.BIN")
    assert numbers(found, "pressure") == [pytest.approx(101325 + 3 * FRESH)]
    assert any("BARO[1] (for pressure)" in sentence for sentence in found.findings)


def test_dataflash_without_an_attitude(tmp_path: Path) -> None:
    """Rates and accelerations are there all the same."""
    (tmp_path / "log.BIN").write_bytes(dataflash(FLAGS["without"], ["ATT"]))
    found = made("ardusub_dataflash", tmp_path / "log.BIN")
    assert topics_of(found) == {"pressure", "imu", "thruster_command"}
    assert numbers(found, "imu") == [0.5, -0.25, -0.125, 1.0, -2.0, 9.75]
    assert any("ATT (for compass and imu)" in sentence for sentence in found.findings)


def test_dataflash_as_another_reader_has_it(tmp_path: Path) -> None:
    """pymavlink reads the same numbers from the same bytes."""
    from pymavlink.DFReader import DFReader_binary

    file = tmp_path / "log.bin"
    file.write_bytes(dataflash(FLAGS["with a place"]))
    theirs = DFReader_binary(str(file))
    theirs.filehandle.close()
    ours = DataFlashLog(file)
    for topic, count in (("XKF1", 2), ("IMU", 2), ("XKF4", 2), ("BARO", 2), ("ATT", 1), ("CTUN", 1), ("RCOU", 1)):
        theirs.rewind()
        found = [theirs.recv_match(type=topic) for _ in range(count)]
        for core, message in enumerate(found):
            rows = ours.rows(topic if count == 1 else f"{topic}[{core}]", Entry("", "map.yaml", 1, "topic"))
            for column in message.fmt.columns:
                cell = Entry(column, "map.yaml", 1, "column")
                assert rows.numbers(cell).tolist() == [pytest.approx(float(getattr(message, column)), rel=1e-12)]


def test_instances_have_to_be_told_apart(tmp_path: Path) -> None:
    """Two lanes of an estimate are not one; the sentence offers both."""
    (tmp_path / "log.bin").write_bytes(dataflash(FLAGS["with a place"]))
    log = DataFlashLog(tmp_path / "log.bin")
    for topic, sentence in (
        ("XKF1", r"names XKF1, of which log.bin has several; write XKF1.0. or XKF1.1."),
        ("XKF1[2]", r"names XKF1.2., which log.bin does not have; write XKF1.0. or XKF1.1."),
    ):
        with pytest.raises(CocorosimError, match=sentence):
            log.rows(topic, Entry(topic, "map.yaml", 1, "topic"))


# tlog


def tlog(logs: SimpleNamespace, without: Sequence[str] = (), yaw: float = math.pi / 2) -> bytes:
    """One message of each kind that the map has, received long after it was sent, without some."""
    parts: Mapping[str, bytes] = {
        "LOCAL_POSITION_NED": logs.local_position(7000, 1.0, 2.0, 3.0, 0, 0, 0),
        "ATTITUDE": logs.mavlink(30, struct.pack("<I6f", 7100, 0.25, -0.5, yaw, 0.5, 0.25, 0.125), 39),
        "SCALED_PRESSURE2": logs.mavlink(137, struct.pack("<Iffh", 7200, 1307.5, 0.0, 2000), 195),
        "GLOBAL_POSITION_INT": logs.mavlink(33, struct.pack("<IiiiihhhH", 7250, 0, 0, 0, -3000, 0, 0, 0, 0), 104),
        "SERVO_OUTPUT_RAW": logs.mavlink(36, struct.pack("<I8HB", 7_300_000, *PULSES, 0, 0, 0), 222),
    }
    kept = [part for name, part in parts.items() if name not in without]
    return b"".join(struct.pack(">Q", 10**15 + row) + part for row, part in enumerate(kept))


def test_tlog_with_a_place(logs: SimpleNamespace, converted: Converted, tmp_path: Path) -> None:
    """Position with the attitude beside it, pressure in hPa, pulses, by the vehicle's own time."""
    (tmp_path / "log.tlog").write_bytes(tlog(logs))
    topics = converted("ardusub_tlog", tmp_path / "log.tlog")
    assert topics.keys() == {f"/rov/{topic}" for topic in ("pose", "imu", "pressure", "thruster_command")}
    assert topics["/rov/pose"][0].at == 7_000_000_000
    assert place(topics["/rov/pose"][0]) == pytest.approx([2, 1, -3, 0], abs=1e-6)
    assert topics["/rov/pressure"][0].content.fluid_pressure == pytest.approx(130750)
    commands = topics["/rov/thruster_command"][0]
    assert commands.at == 7_300_000_000
    assert list(commands.content.command) == pytest.approx(SHARES)


def test_tlog_without_a_place(logs: SimpleNamespace, tmp_path: Path) -> None:
    """Heading, attitude and rates are those of ATTITUDE, at its own time."""
    from scipy.spatial.transform import Rotation

    (tmp_path / "log.tlog").write_bytes(tlog(logs, ["LOCAL_POSITION_NED"], 2.0))
    found = made("ardusub_tlog", tmp_path / "log.tlog")
    assert topics_of(found) == {"compass", "pressure", "imu", "thruster_command"}
    assert numbers(found, "compass") == [pytest.approx(math.pi / 2 - 2.0)]
    *turn, x, y, z = numbers(found, "imu")
    assert list(Rotation.from_quat(turn).as_euler("ZYX")) == pytest.approx([math.pi / 2 - 2.0, 0.5, 0.25])
    assert [x, y, z] == [0.5, -0.25, -0.125]
    assert numbers(found, "pressure") == [pytest.approx(130_750)]
    assert {int(stream.stamp_ns[0]) for stream in found.streams if stream.topic in ("imu", "compass")} == {
        7_100_000_000
    }


def test_tlog_without_the_sensor_in_the_water(logs: SimpleNamespace, tmp_path: Path) -> None:
    """3000 mm below home is a depth of 3 m."""
    (tmp_path / "log.tlog").write_bytes(tlog(logs, ["LOCAL_POSITION_NED", "SCALED_PRESSURE2"]))
    found = made("ardusub_tlog", tmp_path / "log.tlog")
    assert numbers(found, "pressure") == [pytest.approx(101325 + 3 * FRESH)]
    assert found.findings[0].startswith(
        "The log lacks LOCAL_POSITION_NED (for pose) and SCALED_PRESSURE2 (for pressure)"
    )


def test_tlog_of_two_systems(logs: SimpleNamespace, tmp_path: Path) -> None:
    """That a topic is optional settles nothing of which of two is meant."""
    other = struct.pack(">Q", 10**15) + logs.mavlink(30, struct.pack("<I6f", 7100, 0, 0, 0, 0, 0, 0), 39, 2)
    (tmp_path / "log.tlog").write_bytes(tlog(logs) + other)
    with pytest.raises(CocorosimError, match=r"names ATTITUDE, of which log.tlog has several; write ATTITUDE.1. or"):
        made("ardusub_tlog", tmp_path / "log.tlog")
