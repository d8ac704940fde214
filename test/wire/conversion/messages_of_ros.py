"""Bags of ROS 1 and ROS 2 with one message on each topic, and what is read of poses and velocities."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.rosbag1 import Writer as Rosbag1
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

OWN_TYPES = {
    "mavros_msgs/msg/RCOut": "std_msgs/Header header\nuint16[] channels",
    "mavros_msgs/msg/VfrHud": "std_msgs/Header header\nfloat32 airspeed\nfloat32 groundspeed\nint16 heading\n"
    "float32 throttle\nfloat32 altitude\nfloat32 climb",
    "holoocean_interfaces/msg/AgentCommand": "std_msgs/Header header\nfloat64[] command",
}


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
