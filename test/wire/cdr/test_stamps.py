"""Stamps are read from the front of the CDR bytes."""

from __future__ import annotations

import struct
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as some

from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store

STAMP = {"sec": 12, "nanosec": 345}
HEADER = {"header": {"stamp": STAMP, "frame_id": "somewhere"}}


@pytest.mark.parametrize(
    ("type_name", "values"),
    [
        ("geometry_msgs/msg/PoseStamped", HEADER),
        ("cocorosim_msgs/msg/BlssScan", HEADER),
        ("nav_msgs/msg/Odometry", HEADER),
        ("std_msgs/msg/Header", HEADER["header"]),
        ("rosgraph_msgs/msg/Clock", {"clock": STAMP}),
        ("tf2_msgs/msg/TFMessage", {"transforms": [HEADER, {}]}),
        ("visualization_msgs/msg/MarkerArray", {"markers": [HEADER]}),
    ],
)
@pytest.mark.parametrize("little_endian", [True, False])
def test_stamp_of_stamped_types(type_name: str, values: dict[str, Any], little_endian: bool) -> None:
    """A header, a clock, or the first of a list of stamped messages, in either byte order."""
    message = build(type_name, values)
    data = bytes(type_store().serialize_cdr(message, type_name, little_endian=little_endian))
    assert stamp_ns(type_name, data) == 12_000_000_345


@pytest.mark.parametrize(
    "type_name",
    [
        "std_msgs/msg/String",
        "std_msgs/msg/Empty",
        "geometry_msgs/msg/Pose",
        "tf2_msgs/msg/TFMessage",
        "std_msgs/msg/Float64",
    ],
)
def test_no_stamp(type_name: str) -> None:
    """Types without a stamp, and an empty list of transforms, have none."""
    assert stamp_ns(type_name, serialize(build(type_name))) is None


@pytest.mark.parametrize(
    ("schema", "expected"),
    [
        ("std_msgs/Header header\nfloat64 x\n", 7_000_000_008),
        ("# comment\n\nuint8 KIND=3\nstd_msgs/msg/Header header # when\n", 7_000_000_008),
        ("builtin_interfaces/Time stamp\n", 7_000_000_008),
        ("Header header\n", 7_000_000_008),
        ("float64 x\nstd_msgs/Header header\n", None),
        ("std_msgs/Header[] headers\n", None),
        ("", None),
    ],
)
def test_stamp_of_an_unknown_type_by_its_schema(schema: str, expected: int | None) -> None:
    """Of a type that only its recording knows, the schema says whether the stamp comes first."""
    data = b"\x00\x01\x00\x00" + struct.pack("<iId", 7, 8, 1.5)
    assert stamp_ns("their_msgs/msg/Theirs", data, schema) == expected


def test_too_short_for_a_stamp() -> None:
    """Bytes that end before the stamp have none."""
    assert stamp_ns("geometry_msgs/msg/PoseStamped", b"\x00\x01\x00\x00\x01\x00") is None


@given(some.integers(-(2**31), 2**31 - 1), some.integers(0, 999_999_999))
def test_any_stamp_is_read_back(seconds: int, nanoseconds: int) -> None:
    """The whole range of builtin_interfaces/Time survives, also before the epoch."""
    clock = build("rosgraph_msgs/msg/Clock", {"clock": {"sec": seconds, "nanosec": nanoseconds}})
    assert stamp_ns("rosgraph_msgs/msg/Clock", serialize(clock)) == seconds * 10**9 + nanoseconds
