"""The type store knows our types from their .msg files alone, and tells other readers all about them."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr import type_store

DEFINITIONS = Path(__file__).resolve().parents[3] / "msg_defs" / "msg"
OWN_TYPES = [f"cocorosim_msgs/msg/{file.stem}" for file in sorted(DEFINITIONS.glob("*.msg"))]
STANDARD_TYPES = [
    "geometry_msgs/msg/PoseStamped",
    "sensor_msgs/msg/Imu",
    "tf2_msgs/msg/TFMessage",
    "rosgraph_msgs/msg/Clock",
]


def fresh_definitions(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make the store look for the files again in this test."""
    monkeypatch.setattr(type_store, "own_definitions", type_store.own_definitions.__wrapped__)


@pytest.mark.parametrize("type_name", OWN_TYPES)
def test_every_definition_file_is_a_known_type(type_name: str) -> None:
    """Each .msg file of the interface package is a type of the store."""
    assert type_store.is_known(type_name)


@pytest.mark.parametrize("type_name", OWN_TYPES + STANDARD_TYPES)
def test_schema_text_is_complete(type_name: str) -> None:
    """A parser that knows no types at all understands the schema text and finds the same fields."""
    parsed = get_types_from_msg(type_store.schema_text(type_name), type_name)
    empty = get_typestore(Stores.EMPTY)
    empty.register(parsed)
    assert empty.fielddefs[type_name] == type_store.type_store().fielddefs[type_name]
    assert type_store.schema_text(type_name).count("=" * 80) == len(parsed) - 1


def test_schema_text_keeps_our_comments() -> None:
    """Units and frames, which stand in comments, are there for readers of a recording."""
    text = type_store.schema_text("cocorosim_msgs/msg/BlssScan")
    assert "# m to the nearest robot in the cone, +inf for none" in text
    assert "MSG: cocorosim_msgs/BlssReading\n" in text


@pytest.mark.parametrize("type_name", OWN_TYPES + STANDARD_TYPES)
def test_type_hash_is_that_of_the_installed_interface(type_name: str) -> None:
    """The hash is the one that rosidl wrote when it generated the installed package."""
    package, _, name = type_name.split("/")
    file = Path(sys.prefix, "share", package, "msg", f"{name}.json")
    if not file.exists():
        pytest.skip(f"{package} is not installed as a ROS package here")
    hashes = {entry["type_name"]: entry["hash_string"] for entry in json.loads(file.read_text())["type_hashes"]}
    assert type_store.type_hash(type_name) == hashes[type_name]


def test_definitions_of_an_installed_package_come_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An interface package under AMENT_PREFIX_PATH is preferred to the checkout."""
    folder = tmp_path / "second" / "share" / "cocorosim_msgs" / "msg"
    folder.mkdir(parents=True)
    (folder / "Installed.msg").write_text("float64 value\n")
    monkeypatch.setenv("AMENT_PREFIX_PATH", f"{tmp_path / 'first'}:{tmp_path / 'second'}")
    fresh_definitions(monkeypatch)
    assert type_store.own_definitions() == {"cocorosim_msgs/msg/Installed": "float64 value\n"}


def test_definitions_of_the_prefix_are_found_without_ros(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A virtual environment with the interface package in it needs no environment variable."""
    folder = tmp_path / "share" / "cocorosim_msgs" / "msg"
    folder.mkdir(parents=True)
    (folder / "Installed.msg").write_text("float64 value\n")
    monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    fresh_definitions(monkeypatch)
    assert list(type_store.own_definitions()) == ["cocorosim_msgs/msg/Installed"]


def test_missing_definitions_are_said_in_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the interface package the user reads what to install."""
    monkeypatch.setattr(type_store, "definition_folders", lambda: [tmp_path])
    fresh_definitions(monkeypatch)
    with pytest.raises(CocorosimError, match="install cocorosim_ros again"):
        type_store.own_definitions()


def test_build_fills_what_is_not_given_with_nothing() -> None:
    """Numbers are zero, texts and lists empty, fixed arrays of their length; what is given stands."""
    imu = type_store.build("sensor_msgs/msg/Imu", {"header": {"frame_id": "lily_01/base_link"}})
    assert imu.header.frame_id == "lily_01/base_link"
    assert imu.header.stamp.sec == 0
    np.testing.assert_array_equal(imu.orientation_covariance, np.zeros(9))
    command = type_store.build("cocorosim_msgs/msg/ThrusterCommand", {"name": ["left"], "command": [0.5]})
    assert (command.name, list(command.command)) == (["left"], [0.5])


def test_serialised_message_is_the_cdr_of_the_standard() -> None:
    """A Clock of 1 s and 2 ns is: encapsulation (little endian CDR), int32 1, uint32 2."""
    clock = type_store.build("rosgraph_msgs/msg/Clock", {"clock": {"sec": 1, "nanosec": 2}})
    assert type_store.serialize(clock) == bytes.fromhex("000100000100000002000000")


@pytest.mark.parametrize(
    ("type_name", "values", "word"),
    [
        ("no_msgs/msg/Nothing", {}, "no_msgs/msg/Nothing"),
        ("cocorosim_msgs/msg/Compass", {"heeding": 1.0}, "heading"),
    ],
)
def test_unknown_names_are_said(type_name: str, values: dict[str, float], word: str) -> None:
    """An unknown type is named; an unknown field is answered with the fields there are."""
    with pytest.raises(CocorosimError, match=word):
        type_store.build(type_name, values)


@pytest.mark.parametrize("data", [b"", b"\x00\x01", b"\x00\x01\x00\x00" + bytes(5), b"garbage" * 20])
def test_bytes_of_something_else_are_refused(data: bytes) -> None:
    """Bytes that are no such message give a sentence with the type, not a traceback."""
    with pytest.raises(CocorosimError, match="geometry_msgs/msg/PoseStamped"):
        type_store.deserialize("geometry_msgs/msg/PoseStamped", data)
