"""The bytes of everything that a robot's body publishes: from arrays to CDR, all robots at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.world.state.readings import Readings
from cocorosim_ros.world.state.state import YAW, X, Z

WORLD_FRAME = "world"
UNKNOWN_ORIENTATION = np.array([-1.0, 0, 0, 0, 0, 0, 0, 0, 0])  # REP 145: orientation is not estimated


def _templates(bodies: Sequence[BodyDescription], type_name: str, extra: Mapping[str, Any] = {}) -> list[Any]:
    return [type_store.build(type_name, {"header": {"frame_id": body.frame}, **extra}) for body in bodies]


def pose_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`pose`: x, y, z [m; world], then z and w of the attitude quaternion."""
    header = {"header": {"frame_id": WORLD_FRAME}}
    template = [type_store.build("geometry_msgs/msg/PoseStamped", header) for _ in bodies]
    position = [f"pose.position.{axis}" for axis in "xyz"]
    return PackedMessage(template, [*position, "pose.orientation.z", "pose.orientation.w"])


def compass_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`compass`: heading [rad; world]."""
    return PackedMessage(_templates(bodies, "cocorosim_msgs/msg/Compass"), ["heading"])


def pressure_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`pressure`: absolute [Pa]."""
    return PackedMessage(_templates(bodies, "sensor_msgs/msg/FluidPressure"), ["fluid_pressure"])


def imu_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`imu`: angular rate [rad/s; body], then specific force [m/s^2; body]."""
    extra = {"orientation_covariance": UNKNOWN_ORIENTATION, "orientation": {"w": 1.0}}
    fields = [f"angular_velocity.{axis}" for axis in "xyz"] + [f"linear_acceleration.{axis}" for axis in "xyz"]
    return PackedMessage(_templates(bodies, "sensor_msgs/msg/Imu", extra), fields)


def velocity_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`velocity`: u, v, w [m/s; body], r [rad/s]."""
    fields = [*(f"twist.linear.{axis}" for axis in "xyz"), "twist.angular.z"]
    return PackedMessage(_templates(bodies, "geometry_msgs/msg/TwistStamped"), fields)


def scan_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`blss` of robots with the same sensors: neighbour ranges of all sensors, then obstacle ranges [m]."""
    sensors = bodies[0].sensors
    readings = [{"sensor": part.name, "azimuth": part.azimuth, "elevation": part.elevation} for part in sensors]
    template = _templates(bodies, "cocorosim_msgs/msg/BlssScan", {"readings": readings})
    names = [part.name for part in sensors]
    fields = [f"readings[{name}].neighbour_range" for name in names]
    return PackedMessage(template, fields + [f"readings[{name}].obstacle_range" for name in names])


def illuminance_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`illuminance`: ambient light [lx]."""
    return PackedMessage(_templates(bodies, "sensor_msgs/msg/Illuminance"), ["illuminance"])


def concentration_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`concentration`: of the plume's substance [kg/m^3]."""
    return PackedMessage(_templates(bodies, "cocorosim_msgs/msg/Concentration"), ["concentration"])


def command_message(body: BodyDescription) -> PackedMessage:
    """`thruster_command` of one robot: the fraction of each actuator, in the platform's order."""
    extra = {"name": list(body.actuators), "command": [0.0] * len(body.actuators)}
    fields = [f"command[{name}]" for name in body.actuators]
    return PackedMessage(_templates([body], "cocorosim_msgs/msg/ThrusterCommand", extra), fields)


def transform_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`/tf`: per robot x, y, z [m; world], then z and w of the attitude quaternion."""
    transforms = [
        {
            "header": {"frame_id": WORLD_FRAME},
            "child_frame_id": body.frame,
            "transform": {"rotation": {"w": 1.0}},
        }
        for body in bodies
    ]
    parts = ("translation.x", "translation.y", "translation.z", "rotation.z", "rotation.w")
    fields = [f"transforms[#{index}].transform.{part}" for index in range(len(bodies)) for part in parts]
    return PackedMessage([type_store.build("tf2_msgs/msg/TFMessage", {"transforms": transforms})], fields)


class SwarmMessages:
    """Encodes the readings and true poses of all robots of one run."""

    def __init__(self, bodies: Sequence[BodyDescription]) -> None:
        self._bodies = tuple(bodies)
        self._pose = pose_message(bodies)
        self._compass = compass_message(bodies)
        self._pressure = pressure_message(bodies)
        self._imu = imu_message(bodies)
        self._velocity = velocity_message(bodies)
        self._extras = {
            "illuminance": illuminance_message(bodies),
            "concentration": concentration_message(bodies),
        }
        self._scans = [
            (rows, len(sensors), scan_message([bodies[row] for row in rows]))
            for sensors, rows in _robots_by_sensors(bodies).items()
        ]
        self._transforms = transform_message(bodies)
        self._clock = PackedMessage([type_store.build("rosgraph_msgs/msg/Clock")], [])

    def clock(self, stamp_ns: int) -> bytes:
        """The bytes of `/clock`."""
        return self._clock.encode(stamp_ns)[0]

    def poses(self, stamp_ns: int, state: Floats) -> tuple[list[bytes], bytes]:
        """The bytes of every robot's `pose`, and of `/tf`; `state` (robots, columns)."""
        half = 0.5 * state[:, YAW]
        columns = np.column_stack([state[:, X : Z + 1], np.sin(half), np.cos(half)])
        return self._pose.encode(stamp_ns, columns), self._transforms.encode(stamp_ns, columns)[0]

    def readings(self, stamp_ns: int, readings: Readings, run: int = 0) -> dict[str, list[bytes]]:
        """The bytes of every robot's instruments: topic name to one message per robot."""
        inertial = np.hstack([readings.angular_rate[run], readings.specific_force[run]])
        return {
            "compass": self._compass.encode(stamp_ns, readings.compass[run]),
            "pressure": self._pressure.encode(stamp_ns, readings.pressure[run]),
            "imu": self._imu.encode(stamp_ns, inertial),
            "blss": self._encode_scans(stamp_ns, readings, run),
            "velocity": self._velocity.encode(stamp_ns, readings.velocity[run]),
            "illuminance": self._encode_extra("illuminance", stamp_ns, readings.illuminance[run]),
            "concentration": self._encode_extra("concentration", stamp_ns, readings.concentration[run]),
        }

    def _encode_extra(self, topic: str, stamp_ns: int, values: Floats) -> list[bytes]:
        """One message per robot, or none at all where nobody asks for the topic."""
        if not any(topic in body.topics for body in self._bodies):
            return []
        return self._extras[topic].encode(stamp_ns, values)

    def _encode_scans(self, stamp_ns: int, readings: Readings, run: int) -> list[bytes]:
        encoded = [b""] * len(self._bodies)
        for rows, count, scan in self._scans:
            near = readings.neighbour_range[run, rows, :count]
            columns = np.hstack([near, readings.obstacle_range[run, rows, :count]])
            for row, data in zip(rows, scan.encode(stamp_ns, columns), strict=True):
                encoded[row] = data
        return encoded


def _robots_by_sensors(bodies: Sequence[BodyDescription]) -> dict[tuple[BlueLightSensor, ...], list[int]]:
    groups: dict[tuple[BlueLightSensor, ...], list[int]] = {}
    for row, body in enumerate(bodies):
        groups.setdefault(body.sensors, []).append(row)
    return groups
