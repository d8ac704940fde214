"""Recordings as rosbag2 folders with one MCAP file, by the messages of msg_defs/ read as text.

The messages of a stream differ in stamp and numbers only, and the numbers stand last in all of them. So one message is
serialised by the library, and the others are made from it by array arithmetic.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rosbags.interfaces import Connection
from rosbags.rosbag2 import CompressionMode, Writer
from rosbags.rosbag2.enums import CompressionFormat, StoragePlugin
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from concealer.sensors import EPOCH_NS, Stream

MESSAGES = Path(__file__).resolve().parents[2] / "msg_defs" / "msg"
OWN = ("Compass", "ThrusterCommand")
TYPES = {
    "pose": "geometry_msgs/msg/PoseStamped",
    "compass": "cocorosim_msgs/msg/Compass",
    "pressure": "sensor_msgs/msg/FluidPressure",
    "imu": "sensor_msgs/msg/Imu",
    "velocity": "geometry_msgs/msg/TwistStamped",
    "ground_velocity": "geometry_msgs/msg/TwistStamped",
    "thruster_command": "cocorosim_msgs/msg/ThrusterCommand",
}
ACTUATORS = ["left", "right", "buoyancy"]


@cache
def typestore() -> Any:
    """The messages of ROS 2 Jazzy and of this project."""
    store = get_typestore(Stores.ROS2_JAZZY)
    for name in OWN:
        text = (MESSAGES / f"{name}.msg").read_text(encoding="utf-8")
        store.register(get_types_from_msg(text, f"cocorosim_msgs/msg/{name}"))
    return store


def blank(topic: str, frame: str, actuators: list[str]) -> Any:
    """A message of a topic in which all numbers are zero."""
    types = typestore().types
    stamp = types["builtin_interfaces/msg/Time"](0, 0)
    header = types["std_msgs/msg/Header"](stamp, frame)
    kind = types[TYPES[topic]]
    vector = types["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0)
    turn = types["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
    if topic == "pose":
        return kind(header, types["geometry_msgs/msg/Pose"](types["geometry_msgs/msg/Point"](0.0, 0.0, 0.0), turn))
    if topic in ("velocity", "ground_velocity"):
        return kind(header, types["geometry_msgs/msg/Twist"](vector, vector))
    if topic == "imu":
        nine = np.zeros(9)
        return kind(header, turn, nine, vector, nine, vector, nine)
    if topic == "thruster_command":
        return kind(header, actuators, np.zeros(len(actuators)))
    return kind(header, 0.0, 0.0)


def encoded(
    stream: Stream, robot: str, epoch_ns: int, actuators: list[str]
) -> tuple[NDArray[np.int64], NDArray[np.uint8]]:
    """Log times (n,) [ns] and messages (n, bytes) of a stream whose time counts from epoch_ns, in CDR."""
    frame = "world" if stream.topic == "pose" else f"{robot}/base_link"
    empty = blank(stream.topic, frame, actuators)
    template = np.frombuffer(bytes(typestore().serialize_cdr(empty, TYPES[stream.topic])), np.uint8)
    count, numbers = stream.values.shape
    data = np.tile(template, (count, 1))
    stamps = epoch_ns + np.rint(stream.stamp * 1e9).astype(np.int64)
    data[:, 4:8] = (stamps // 10**9).astype("<i4")[:, None].view(np.uint8)
    data[:, 8:12] = (stamps % 10**9).astype("<u4")[:, None].view(np.uint8)
    data[:, template.size - 8 * numbers :] = np.ascontiguousarray(stream.values, "<f8").view(np.uint8)
    return epoch_ns + np.rint(stream.logged * 1e9).astype(np.int64), data


def new_writer(path: Path) -> Writer:
    """A writer of a new folder, whose chunks are compressed."""
    writer = Writer(path, version=9, storage_plugin=StoragePlugin.MCAP)
    writer.set_compression(CompressionMode.STORAGE, CompressionFormat.ZSTD)
    return writer


def write(
    path: Path, robots: dict[str, list[Stream]], epoch_ns: int = EPOCH_NS, actuators: list[str] = ACTUATORS
) -> None:
    """Writes a new recording that begins at epoch_ns; robots by namespace. Raises WriterError if the folder exists."""
    with new_writer(path) as writer:
        times: list[NDArray[np.int64]] = []
        order: list[tuple[Connection, int, int]] = []
        bodies: list[NDArray[np.uint8]] = []
        for robot, streams in robots.items():
            for stream in streams:
                link = writer.add_connection(f"/{robot}/{stream.topic}", TYPES[stream.topic], typestore=typestore())
                logged, data = encoded(stream, robot, epoch_ns, actuators)
                order += [(link, len(bodies), k) for k in range(len(data))]
                times.append(logged)
                bodies.append(data)
        stamps = np.concatenate(times)
        for n in np.argsort(stamps, kind="stable"):
            link, body, k = order[n]
            writer.write(link, int(stamps[n]), bodies[body][k].tobytes())
