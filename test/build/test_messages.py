"""The messages of msg_defs, as built into this environment."""

from __future__ import annotations

import importlib
import math
import re
import struct
from pathlib import Path

import pytest
from geometry_msgs.msg import Vector3
from rclpy.serialization import deserialize_message, serialize_message
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from std_msgs.msg import Header

MESSAGE_FILES = sorted(Path(__file__).parents[2].glob("msg_defs/msg/*.msg"))


def message_class(name: str) -> type:
    """The class that rosidl has generated for cocorosim_msgs/`name`."""
    return getattr(importlib.import_module("cocorosim_msgs.msg"), name)


def filled(kind: type) -> object:
    """A message of `kind` in which no field has its initial value; lists of ours hold one element."""
    values = {
        "double": 0.1,
        "uint32": 7,
        "string": "lily_01",
        "sequence<double>": [0.1, math.inf],
        "sequence<string>": ["left"],
        "std_msgs/Header": Header(frame_id="world"),
        "sequence<geometry_msgs/Vector3>": [Vector3(x=0.1, y=-0.2, z=math.inf)],
    }
    message = kind()
    for field, type_name in kind.get_fields_and_field_types().items():
        nested = re.fullmatch(r"sequence<cocorosim_msgs/(\w+)>", type_name)
        setattr(message, field, [filled(message_class(nested[1]))] if nested else values[type_name])
    return message


def test_there_are_messages() -> None:
    """The folder msg_defs/msg is found, so that the tests below are about something."""
    assert {"BlssScan", "Compass", "ThrusterCommand"} <= {file.stem for file in MESSAGE_FILES}


@pytest.mark.parametrize("file", MESSAGE_FILES, ids=lambda file: file.stem)
def test_a_message_survives_its_own_bytes(file: Path) -> None:
    """A message of each type, its numbers and texts set, is equal to what its bytes give."""
    kind = message_class(file.stem)
    message = filled(kind)
    assert message != kind()
    again = deserialize_message(serialize_message(message), kind)
    assert again == message


@pytest.mark.parametrize("file", MESSAGE_FILES, ids=lambda file: file.stem)
def test_a_message_has_the_fields_of_its_file(file: Path) -> None:
    """The generated class has the fields of the .msg file as rosbags, an independent parser, reads it."""
    types = get_types_from_msg(file.read_text(encoding="utf-8"), f"cocorosim_msgs/msg/{file.stem}")
    fields = types[f"cocorosim_msgs/msg/{file.stem}"][1]
    assert list(message_class(file.stem).get_fields_and_field_types()) == [name for name, _ in fields]


def test_bytes_are_plain_cdr() -> None:
    """A compass message is, byte for byte, what the CDR rules give by hand."""
    compass = message_class("Compass")(heading=1.5, variance=0.25)
    compass.header.stamp.sec = 7
    compass.header.stamp.nanosec = 500_000_000
    compass.header.frame_id = "a"
    encapsulation = bytes([0, 1, 0, 0])
    stamp = struct.pack("<iI", 7, 500_000_000)
    frame = struct.pack("<I", 2) + b"a\0"
    data = serialize_message(compass)
    assert data[:18] == encapsulation + stamp + frame
    # Two bytes of padding, whose value CDR leaves open: doubles start at 4 plus a multiple of 8.
    assert data[20:] == struct.pack("<dd", 1.5, 0.25)


def test_an_independent_reader_understands_the_bytes() -> None:
    """What rosbags makes of the bytes of a blue-light scan are the values that were set."""
    scan = message_class("BlssScan")()
    reading = message_class("BlssReading")(sensor="front", azimuth=0.5, elevation=-0.5)
    reading.neighbour_range, reading.obstacle_range = 0.4, math.inf
    scan.readings = [reading]
    store = get_typestore(Stores.ROS2_JAZZY)
    for file in MESSAGE_FILES:
        store.register(get_types_from_msg(file.read_text(encoding="utf-8"), f"cocorosim_msgs/msg/{file.stem}"))
    reading = store.deserialize_cdr(serialize_message(scan), "cocorosim_msgs/msg/BlssScan").readings[0]
    assert (reading.sensor, reading.azimuth, reading.elevation) == ("front", 0.5, -0.5)
    assert (reading.neighbour_range, reading.obstacle_range) == (0.4, math.inf)
