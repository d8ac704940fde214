"""Bags of ROS 1 and of ROS 2 in SQLite, written by rosbags, which knows nothing of us."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from rosbags.rosbag1 import Writer as Rosbag1
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

OWN = "std_msgs/Header header\nfloat32 rpm\nuint16[2] pulses"
TABLES = """\
  - topic: /velocity
    robot: boat
    streams: {velocity: {x: {column: twist.linear.x}}}
  - topic: /motor
    robot: boat
    streams:
      thruster_command:
        jet: {column: "pulses[1]", unit: us, stop: 1000 us, forward: 2000 us}
        main: {formula: "rpm**2", unit: "1", stop: 0, forward: 10000}
"""
Convert = Callable[..., SimpleNamespace]


@pytest.fixture
def convert_source(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> Convert:
    """Function of (source, tables): the messages and findings of the conversion."""

    def run(source: Path, tables: str = TABLES) -> SimpleNamespace:
        (tmp_path / "map.yaml").write_text(f"name: m\nformat: bag\ntables:\n{tables}")
        done = convert(load_map(tmp_path / "map.yaml"), source, tmp_path / "ours", force=True)
        return SimpleNamespace(topics=messages(done[0].folder), findings=done[0].conversion.findings)

    return run


def ros1_bag(path: Path, compression: Rosbag1.CompressionFormat | None = None) -> Path:
    """Two topics, one of a type of the recorder's own."""
    store = get_typestore(Stores.ROS1_NOETIC)
    store.register(get_types_from_msg(OWN, "boat_msgs/msg/Motor"))
    types = store.types
    zero = types["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0)
    rosbag1 = Rosbag1(path)
    if compression:
        rosbag1.set_compression(compression)
    with rosbag1 as writer:
        velocity = writer.add_connection("/velocity", "geometry_msgs/msg/TwistStamped", typestore=store)
        motor = writer.add_connection("/motor", "boat_msgs/msg/Motor", typestore=store)
        for row in range(3):
            time = types["builtin_interfaces/msg/Time"](row, 5)
            header = types["std_msgs/msg/Header"](row, time, "")
            speed = types["geometry_msgs/msg/Vector3"](0.5 * row, 0.0, 0.0)
            twist = types["geometry_msgs/msg/TwistStamped"](header, types["geometry_msgs/msg/Twist"](speed, zero))
            message = types["boat_msgs/msg/Motor"](header, 50.0, _pulses(1250))
            writer.write(velocity, 7 + row, store.serialize_ros1(twist, velocity.msgtype))
            writer.write(motor, 8 + row, store.serialize_ros1(message, motor.msgtype))
    return path


def _pulses(second: int) -> Any:
    import numpy as np

    return np.array([0, second], dtype=np.uint16)


def sqlite_bag(folder: Path) -> Path:
    """The same as a rosbag2 folder in SQLite."""
    store = get_typestore(Stores.ROS2_JAZZY)
    store.register(get_types_from_msg(OWN, "boat_msgs/msg/Motor"))
    types = store.types
    zero = types["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0)
    with Writer(folder, version=9, storage_plugin=StoragePlugin.SQLITE3) as writer:
        velocity = writer.add_connection("/velocity", "geometry_msgs/msg/TwistStamped", typestore=store)
        motor = writer.add_connection("/motor", "boat_msgs/msg/Motor", typestore=store)
        for row in range(3):
            header = types["std_msgs/msg/Header"](types["builtin_interfaces/msg/Time"](row, 5), "")
            speed = types["geometry_msgs/msg/Vector3"](0.5 * row, 0.0, 0.0)
            twist = types["geometry_msgs/msg/TwistStamped"](header, types["geometry_msgs/msg/Twist"](speed, zero))
            message = types["boat_msgs/msg/Motor"](header, 50.0, _pulses(1250))
            writer.write(velocity, 7 + row, store.serialize_cdr(twist, velocity.msgtype))
            writer.write(motor, 8 + row, store.serialize_cdr(message, motor.msgtype))
    return folder


def check(result: SimpleNamespace) -> None:
    """Every number and every stamp of the three rows."""
    speeds = [(message.at, message.content.twist.linear.x) for message in result.topics["/boat/velocity"]]
    assert speeds == [(5, 0.0), (10**9 + 5, 0.5), (2 * 10**9 + 5, 1.0)]
    commands = [(message.at, *message.content.command) for message in result.topics["/boat/thruster_command"]]
    assert commands == [(at, 0.25, 0.25) for at, _ in speeds]
    assert result.findings == ()


@pytest.mark.parametrize("compression", [None, *Rosbag1.CompressionFormat])
def test_ros_1(tmp_path: Path, convert_source: Convert, compression: Any) -> None:
    """The bag's own text of every type is enough, packed or not."""
    check(convert_source(ros1_bag(tmp_path / "log.bag", compression)))


@pytest.mark.parametrize("bare", [False, True])
def test_sqlite(tmp_path: Path, convert_source: Convert, bare: bool) -> None:
    """A folder with metadata, or the file alone."""
    folder = sqlite_bag(tmp_path / "theirs")
    check(convert_source(next(folder.glob("*.db3")) if bare else folder))


def test_sqlite_without_texts_of_types(tmp_path: Path, convert_source: Convert) -> None:
    """Before ROS 2 Iron: standard types are known, others are refused with the way out."""
    folder = sqlite_bag(tmp_path / "theirs")
    (file,) = folder.glob("*.db3")
    connection = sqlite3.connect(file)
    connection.execute("DROP TABLE message_definitions")
    connection.commit()
    connection.close()
    standard = TABLES[: TABLES.index("  - topic: /motor")]
    assert len(convert_source(folder, standard).topics["/boat/velocity"]) == 3
    with pytest.raises(CocorosimError, match="type boat_msgs/msg/Motor, whose text the bag does not hold; leave the"):
        convert_source(folder)


def _cut(file: Path, part: float) -> None:
    file.write_bytes(file.read_bytes()[: int(part * file.stat().st_size)])


@pytest.mark.parametrize("part", [0.0, 0.1, 0.5, 0.9])
def test_bags_that_end_early(tmp_path: Path, convert_source: Convert, part: float) -> None:
    """One sentence each."""
    bag, folder = ros1_bag(tmp_path / "log.bag"), sqlite_bag(tmp_path / "theirs")
    (file,) = folder.glob("*.db3")
    for source, damaged in ((bag, bag), (folder, file)):
        _cut(damaged, part)
        with pytest.raises(CocorosimError, match=r"damaged or ends early|is empty|not a .* bag|reindex") as caught:
            convert_source(source)
        assert "\n" not in str(caught.value) and damaged.name in str(caught.value)


def test_a_bag_that_was_not_closed(tmp_path: Path, convert_source: Convert) -> None:
    """ROS 1 leaves the place of the index at zero: the command that repairs it is said."""
    bag = ros1_bag(tmp_path / "log.bag")
    content = bag.read_bytes()
    at = content.index(b"index_pos=") + len(b"index_pos=")
    bag.write_bytes(content[:at] + bytes(8) + content[at + 8 :])
    sentence = r"was not closed when it was recorded; repair it by `rosbag reindex log.bag`"
    with pytest.raises(CocorosimError, match=sentence):
        convert_source(bag)


@pytest.mark.parametrize("length", [8, 300])
def test_an_mcap_without_a_whole_message(tmp_path: Path, convert_source: Convert, length: int) -> None:
    """The file is called damaged, and no list of topics is asked for where there is none."""
    (tmp_path / "log.mcap").write_bytes(b"\x89MCAP0\r\n".ljust(length, b"\1"))
    with pytest.raises(CocorosimError, match=r"log\.mcap .*damaged.*; copy it again or give another") as caught:
        convert_source(tmp_path / "log.mcap")
    assert "allowed: nothing" not in str(caught.value)


def test_another_database(tmp_path: Path, convert_source: Convert) -> None:
    """SQLite that is no recording."""
    connection = sqlite3.connect(tmp_path / "log.db3")
    connection.execute("CREATE TABLE songs (name TEXT)")
    connection.commit()
    connection.close()
    with pytest.raises(CocorosimError, match=r"cannot be read as a rosbag2 recording in SQLite .no such table"):
        convert_source(tmp_path / "log.db3")


def test_a_bag_where_a_recording_is_asked_for(tmp_path: Path) -> None:
    """Other commands name the kind of file and `convert`."""
    from cocorosim_ros.wire.bags.bag_reader import read_bag

    with pytest.raises(CocorosimError, match="is not an MCAP file: it is a ROS 1 bag; write a map with 'format: bag'"):
        read_bag(ros1_bag(tmp_path / "log.bag"))
