"""The bytes of everything that a robot's body publishes: from arrays to CDR, all robots at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.stick_mixing import StickMixing
from cocorosim_ros.scenario.parts.vehicle_parts import BlueLightSensor
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.pose import POSE
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.sensors.sensor import PER_CONE, Sensor
from cocorosim_ros.world.state.state import YAW, X, Z

WORLD_FRAME = "world"


def _templates(bodies: Sequence[BodyDescription], type_name: str, extra: Mapping[str, Any] = {}) -> list[Any]:
    return [type_store.build(type_name, {"header": {"frame_id": body.frame}, **extra}) for body in bodies]


def pose_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`pose`: x, y, z [m; world], then the attitude quaternion x, y, z, w."""
    header = {"header": {"frame_id": WORLD_FRAME}}
    return PackedMessage([type_store.build(POSE.message, header) for _ in bodies], POSE.layout(()).places)


def sensor_message(sensor: Sensor, bodies: Sequence[BodyDescription]) -> PackedMessage:
    """The messages of a sensor of robots with the same blue-light sensors: its numbers in the order of its fields."""
    layout = sensor.layout(bodies[0].sensors)
    return PackedMessage(_templates(bodies, sensor.message, layout.content), layout.places)


def command_message(body: BodyDescription) -> PackedMessage:
    """`thruster_command` of one robot: the fraction of each actuator, in the platform's order."""
    return _named_commands(body, body.actuators)


def stick_message(body: BodyDescription, mixing: StickMixing) -> PackedMessage:
    """`thruster_command` of a robot commanded by sticks: these, then the fractions of actuators that none drives."""
    return _named_commands(body, mixing.names)


def _named_commands(body: BodyDescription, names: Sequence[str]) -> PackedMessage:
    extra = {"name": list(names), "command": [0.0] * len(names)}
    fields = [f"command[{name}]" for name in names]
    return PackedMessage(_templates([body], "cocorosim_msgs/msg/ThrusterCommand", extra), fields)


def transform_message(bodies: Sequence[BodyDescription]) -> PackedMessage:
    """`/tf`: per robot x, y, z [m; world], then the attitude quaternion x, y, z, w."""
    transforms = [
        {
            "header": {"frame_id": WORLD_FRAME},
            "child_frame_id": body.frame,
            "transform": {"rotation": {"w": 1.0}},
        }
        for body in bodies
    ]
    parts = (*(f"translation.{axis}" for axis in "xyz"), *(f"rotation.{axis}" for axis in "xyzw"))
    fields = [f"transforms[#{index}].transform.{part}" for index in range(len(bodies)) for part in parts]
    return PackedMessage([type_store.build("tf2_msgs/msg/TFMessage", {"transforms": transforms})], fields)


class SensorMessages:
    """Encodes the readings of one sensor of all robots of one run."""

    def __init__(self, sensor: Sensor, bodies: Sequence[BodyDescription]) -> None:
        self._names = [field.name for field in sensor.fields]
        self._count = len(bodies)
        by_cone = any(field.width == PER_CONE for field in sensor.fields)
        groups = _robots_by_sensors(bodies) if by_cone else {(): list(range(len(bodies)))}
        self._groups = [
            (rows, len(cones) if by_cone else None, sensor_message(sensor, [bodies[row] for row in rows]))
            for cones, rows in groups.items()
        ]

    def encode(self, stamp_ns: int, readings: Readings, run: int) -> list[bytes]:
        """One message for each robot."""
        values = [getattr(readings, name)[run] for name in self._names]
        rows, count, message = self._groups[0]
        if count is None:
            return message.encode(stamp_ns, values[0] if len(values) == 1 else np.hstack(values))
        encoded = [b""] * self._count
        for rows, count, message in self._groups:
            columns = np.hstack([part[rows, :count] for part in values])
            for row, data in zip(rows, message.encode(stamp_ns, columns), strict=True):
                encoded[row] = data
        return encoded


class SwarmMessages:
    """Encodes the readings and true poses of all robots of one run."""

    def __init__(self, bodies: Sequence[BodyDescription]) -> None:
        self._pose = pose_message(bodies)
        published = {topic for body in bodies for topic in body.topics}
        self._sensors = {
            topic: SensorMessages(sensor, bodies)
            for topic, sensor in SENSORS.items()
            if sensor.measure is not None and topic in published
        }
        self._transforms = transform_message(bodies)
        self._clock = PackedMessage([type_store.build("rosgraph_msgs/msg/Clock")], [])

    def clock(self, stamp_ns: int) -> bytes:
        """The bytes of `/clock`."""
        return self._clock.encode(stamp_ns)[0]

    def poses(self, stamp_ns: int, state: Floats, attitude: Floats) -> tuple[list[bytes], bytes]:
        """The bytes of every robot's `pose`, and of `/tf`; `state` (robots, columns), `attitude` (robots, 4)."""
        columns = np.column_stack([state[:, X : Z + 1], attitude])
        return self._pose.encode(stamp_ns, columns), self._transforms.encode(stamp_ns, columns)[0]

    def transforms(self, stamp_ns: int, state: Floats) -> bytes:
        """The bytes of `/tf` alone, of robots that neither roll nor pitch."""
        half = 0.5 * state[:, YAW]
        zero = np.zeros_like(half)
        columns = np.column_stack([state[:, X : Z + 1], zero, zero, np.sin(half), np.cos(half)])
        return self._transforms.encode(stamp_ns, columns)[0]

    def readings(self, stamp_ns: int, readings: Readings, run: int = 0) -> dict[str, list[bytes]]:
        """The bytes of the sensors that some robot publishes: topic name to one message per robot."""
        return {topic: messages.encode(stamp_ns, readings, run) for topic, messages in self._sensors.items()}


def _robots_by_sensors(bodies: Sequence[BodyDescription]) -> dict[tuple[BlueLightSensor, ...], list[int]]:
    groups: dict[tuple[BlueLightSensor, ...], list[int]] = {}
    for row, body in enumerate(bodies):
        groups.setdefault(body.sensors, []).append(row)
    return groups
