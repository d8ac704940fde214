"""Packed messages are, byte for byte, what the general serialiser writes, and read whatever it can read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some
from numpy.typing import NDArray

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr import field_paths
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store

POSE = "geometry_msgs/msg/PoseStamped"
POSE_FIELDS = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
COMMAND_FIELDS = ["command[left]", "command[right]", "command[buoyancy]"]
SENSORS = ["front", "left_front", "right", "up", "d"]


def pose(frame: str) -> Any:
    """A pose in a frame, all zero."""
    return build(POSE, {"header": {"frame_id": frame}})


def command(names: list[str], values: list[float] | None = None) -> Any:
    """A command for actuators."""
    given_values = [0.0] * len(names) if values is None else values
    return build("cocorosim_msgs/msg/ThrusterCommand", {"name": names, "command": given_values})


def scan(sensors: list[str], frame: str = "lily_01/base_link") -> Any:
    """A scan of these sensors."""
    readings = [{"sensor": sensor, "azimuth": 0.5 * index} for index, sensor in enumerate(sensors)]
    return build("cocorosim_msgs/msg/BlssScan", {"header": {"frame_id": frame}, "readings": readings})


CASES = {
    "pose": ([pose(frame) for frame in ("world", "map", "world", "odometry")], POSE_FIELDS),
    "imu": (
        [build("sensor_msgs/msg/Imu", {"orientation_covariance": [-1, *[0] * 8]})] * 3,
        ["linear_acceleration.z", "angular_velocity.x", "angular_velocity_covariance[4]"],
    ),
    "scan": (
        [scan(SENSORS), scan(SENSORS, "b"), scan(SENSORS)],
        [f"readings[{name}].obstacle_range" for name in SENSORS],
    ),
    "command": ([command(["left", "right", "buoyancy"])] * 2, COMMAND_FIELDS[::-1]),
    "transforms": (
        [build("tf2_msgs/msg/TFMessage", {"transforms": [{"child_frame_id": "a"}, {"child_frame_id": "b"}]})],
        [f"transforms[{name}].transform.translation.x" for name in ("a", "b")],
    ),
    "clock": ([build("rosgraph_msgs/msg/Clock")], []),
    "shoal": (
        [build("cocorosim_msgs/msg/ShoalStatistics", {"name": ["a", "b"], "unit": ["1"], "value": [0, 0]})],
        ["value[b]", "value[a]"],
    ),
}  # fmt: skip


def expected_bytes(template: Any, fields: list[str], stamp_ns: int, values: NDArray[np.float64]) -> bytes:
    """What the general serialiser writes; the template is overwritten."""
    for path, value in zip(fields, values, strict=True):
        field_paths.write(template, field_paths.steps(path), float(value))
    for path in field_paths.times_in(template):
        time = field_paths.owner_of(template, field_paths.steps(path))
        time.sec, time.nanosec = divmod(stamp_ns, 10**9)
    return serialize(template)


@pytest.mark.parametrize("case", CASES)
def test_bytes_are_those_of_the_general_serialiser(case: str) -> None:
    """Encoding n robots at once gives the bytes of each message serialised alone, also for unlike frames."""
    templates, fields = CASES[case]
    columns = np.random.default_rng(3).normal(size=(len(templates), len(fields)))
    encoded = PackedMessage(templates, fields).encode(12_000_000_345, columns)
    for row, data in enumerate(encoded):
        assert data == expected_bytes(templates[row], fields, 12_000_000_345, columns[row])


@pytest.mark.parametrize("case", CASES)
def test_what_was_encoded_is_decoded(case: str) -> None:
    """Decoding gives the columns back, in the order of the fields."""
    templates, fields = CASES[case]
    packed = PackedMessage(templates, fields)
    columns = np.random.default_rng(4).normal(size=(len(templates), len(fields)))
    for row, data in enumerate(packed.encode(5, columns)):
        np.testing.assert_array_equal(packed.decode(data, row), columns[row])


@given(
    some.lists(some.floats(width=64), min_size=7, max_size=7),
    some.integers(-(2**31), 2**31 - 1),
    some.integers(0, 10**9 - 1),
)
def test_every_float_and_stamp_survives_bit_by_bit(values: list[float], seconds: int, nanoseconds: int) -> None:
    """NaN payloads, signed zeros, infinities and all stamps are encoded as the serialiser does."""
    stamp_ns = seconds * 10**9 + nanoseconds
    columns = np.array([values])
    data = PackedMessage([pose("world")], POSE_FIELDS).encode(stamp_ns, columns)[0]
    assert data == expected_bytes(pose("world"), POSE_FIELDS, stamp_ns, columns[0])


def test_each_robot_may_have_its_own_stamp() -> None:
    """Stamps may be given per robot, and per robot and stamp field."""
    packed = PackedMessage([pose("world"), pose("map")], POSE_FIELDS)
    columns = np.zeros((2, 7))
    first, second = packed.encode(10, columns)[0], packed.encode(3_000_000_020, columns)[1]
    assert packed.encode(np.array([10, 3_000_000_020]), columns) == [first, second]
    assert packed.encode(np.array([[10], [3_000_000_020]]), columns) == [first, second]


@given(some.text(max_size=12), some.booleans())
def test_another_frame_is_decoded_all_the_same(frame: str, little_endian: bool) -> None:
    """A message with another frame_id, or in the other byte order, gives the same numbers."""
    packed = PackedMessage([pose("world")], POSE_FIELDS)
    message = build(
        POSE, {"header": {"frame_id": frame.replace("\x00", "")}, "pose": {"position": {"x": 1.5, "z": -2.0}}}
    )
    data = bytes(type_store().serialize_cdr(message, POSE, little_endian=little_endian))
    np.testing.assert_array_equal(packed.decode(data), [1.5, 0, -2, 0, 0, 0, 0])


def test_padding_that_is_not_zero_is_no_matter() -> None:
    """Real serialisers leave arbitrary bytes between fields; the numbers are read all the same."""
    packed = PackedMessage([pose("world")], POSE_FIELDS)
    data = bytearray(packed.encode(0, np.arange(7.0)[None])[0])
    assert data[22:28] == bytes(6)  # "world" and its end take bytes 16 to 21 of the message, numbers begin at 28
    data[22:28] = b"\xa5" * 6
    np.testing.assert_array_equal(packed.decode(bytes(data)), np.arange(7.0))


def test_another_order_of_names_is_decoded_by_name() -> None:
    """A foreign controller may name the actuators in any order."""
    packed = PackedMessage([command(["left", "right", "buoyancy"])], COMMAND_FIELDS)
    data = serialize(command(["buoyancy", "left", "right"], [0.3, 0.1, 0.2]))
    np.testing.assert_array_equal(packed.decode(data), [0.1, 0.2, 0.3])


def test_a_missing_name_is_nan() -> None:
    """An actuator that a command does not mention has no number."""
    packed = PackedMessage([command(["left", "right", "buoyancy"])], COMMAND_FIELDS)
    np.testing.assert_array_equal(packed.decode(serialize(command(["right"], [0.2]))), [np.nan, 0.2, np.nan])


def test_fewer_sensors_are_nan() -> None:
    """A robot with fewer sensors than the platform file says lacks numbers, and no others move."""
    packed = PackedMessage([scan(SENSORS)], [f"readings[{name}].azimuth" for name in SENSORS])
    np.testing.assert_array_equal(packed.decode(serialize(scan([]))), [np.nan] * 5)
    np.testing.assert_array_equal(packed.decode(serialize(scan(["x", "up"][1:]))), [np.nan, np.nan, np.nan, 0, np.nan])


@pytest.mark.parametrize(
    ("message", "words"),
    [
        (command(["left", "rudder"], [0.1, 0.2]), "'rudder'.*left, right, buoyancy"),
        (command(["left", "left"], [0.1, 0.2]), "two entries 'left'"),
        (command(["left"], [0.1, 0.2]), "1 names for 2 entries"),
    ],
)
def test_unusable_names_are_said(message: Any, words: str) -> None:
    """Unknown, doubled and miscounted names are refused in a sentence."""
    packed = PackedMessage([command(["left", "right", "buoyancy"])], COMMAND_FIELDS)
    with pytest.raises(CocorosimError, match=words):
        packed.decode(serialize(message))


@given(some.binary(max_size=120))
def test_garbage_never_escapes_as_another_error(data: bytes) -> None:
    """Whatever bytes arrive, they are numbers or a CocorosimError."""
    packed = PackedMessage([scan(["a", "b"])], ["readings[a].azimuth"])
    try:
        assert packed.decode(b"\x00\x01\x00\x00" + data).shape == (1,)
    except CocorosimError:
        pass


def test_a_field_that_is_no_float64_is_refused() -> None:
    """Only numbers of 8 bytes can be packed."""
    with pytest.raises((ValueError, TypeError)):
        PackedMessage([build("sensor_msgs/msg/Joy", {"axes": [0.0]})], ["axes[0]"])


def test_rclpy_reads_what_we_write_and_writes_what_we_read() -> None:
    """The bytes are those of rclpy's serialiser, whose padding alone is arbitrary."""
    serialization = pytest.importorskip("rclpy.serialization")
    messages = pytest.importorskip("geometry_msgs.msg")
    values = np.random.default_rng(5).normal(size=7)
    for frame in ["", "a", "wor", "world", "lily_01/base_link"]:
        packed = PackedMessage([pose(frame)], POSE_FIELDS)
        ours = packed.encode(3_000_000_004, values[None])[0]
        message = serialization.deserialize_message(ours, messages.PoseStamped)
        assert (message.header.stamp.sec, message.header.stamp.nanosec, message.header.frame_id) == (
            3,
            4,
            frame,
        )
        position, orientation = message.pose.position, message.pose.orientation
        read = [
            position.x,
            position.y,
            position.z,
            orientation.x,
            orientation.y,
            orientation.z,
            orientation.w,
        ]
        assert read == values.tolist()
        theirs = serialization.serialize_message(message)
        padded = slice(16 + len(frame) + 1, len(theirs) - 56)  # between the frame_id and the seven numbers
        assert theirs[: padded.start] + ours[padded] + theirs[padded.stop :] == ours
        np.testing.assert_array_equal(packed.decode(theirs), values)
