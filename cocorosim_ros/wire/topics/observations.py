"""From the bytes of one robot's topics to what its controller sees, and from its answer to bytes."""

from __future__ import annotations

from typing import Any

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr.acoustic_messages import hear_sound
from cocorosim_ros.wire.cdr.neighbours import read_neighbours
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.radio_messages import RadioEncoder, RadioMessage, hear
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.swarm_messages import command_message, sensor_message
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.sensor import PER_CONE, Field, Sensor
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.radio import MESSAGE_SIZE, read_payload
from cocorosim_ros.world.state.sound import SOUND_SIZE


class ObservationDecoder:
    """Turns the latest bytes of each topic of one robot into its Observation; absent topics read as NaN.

    A blue-light sensor that is not in the message reads as +inf: it sees nothing.
    """

    def __init__(self, body: BodyDescription, hearing_limit: int) -> None:
        self._heard = np.zeros((hearing_limit, MESSAGE_SIZE))
        self._light = np.zeros((hearing_limit, MESSAGE_SIZE))
        self._sound = np.zeros((hearing_limit, SOUND_SIZE))
        self._offset = np.zeros((hearing_limit, 3))
        self._velocity = np.zeros((hearing_limit, 3))
        seen = [sensor for sensor in SENSORS.values() if _is_seen(sensor)]
        self._places = [_places(sensor, len(body.sensors)) for sensor in seen]
        self._numbers: dict[str, PackedMessage] = {
            sensor.topic: sensor_message(sensor, [body])
            for sensor in seen
            if body.sensors or not any(field.width == PER_CONE for field in sensor.fields)
        }

    def observation(self, time: float, latest: dict[str, bytes]) -> Observation:
        """What the robot knows at `time` [s]. Raises CocorosimError for bytes that hold something else."""
        return Observation(
            time=time,
            heard_count=hear(latest.get("radio_rx"), self._heard),
            heard=self._heard,
            light_count=hear(latest.get("blue_light_rx"), self._light),
            light=self._light,
            sound_count=hear_sound(latest.get("acoustic_rx"), self._sound),
            sound=self._sound,
            neighbour_count=self._look_around(latest.get("neighbours")),
            neighbour_offset=self._offset,
            neighbour_velocity=self._velocity,
            **self._readings(latest),
        )

    def _readings(self, latest: dict[str, bytes]) -> dict[str, Any]:
        """What every sensor shows, by the fields of Observation."""
        shown: dict[str, Any] = {}
        for topic, count, fields in self._places:
            numbers = self._read(topic, latest, count)
            for field, place in fields:
                part = numbers[place]
                if field.width == PER_CONE:
                    part = np.where(np.isnan(part), np.inf, part)
                shown[field.name] = float(part[0]) if field.width is None else part
        return shown

    def _read(self, topic: str, latest: dict[str, bytes], count: int) -> Floats:
        if topic not in latest or topic not in self._numbers:
            return np.full(count, np.nan)
        return self._numbers[topic].decode(latest[topic])

    def _look_around(self, data: bytes | None) -> int:
        if data is None:
            return 0
        names, offset, velocity = read_neighbours(data)
        count = min(len(names), self._offset.shape[0])
        self._offset[:count], self._velocity[:count] = offset[:count], velocity[:count]
        return count


def _is_seen(sensor: Sensor) -> bool:
    """Whether controllers see what a sensor shows."""
    return bool(sensor.fields) and all(field.name in Observation._fields for field in sensor.fields)


def _places(sensor: Sensor, cones: int) -> tuple[str, int, list[tuple[Field, slice]]]:
    """Topic of a sensor, how many numbers its message holds, and where each field stands among them."""
    fields, first = [], 0
    for field in sensor.fields:
        width = cones if field.width == PER_CONE else field.width or 1
        fields.append((field, slice(first, first + width)))
        first += width
    return sensor.topic, first, fields


class AnswerEncoder:
    """Turns one controller's answer into bytes."""

    def __init__(self, body: BodyDescription) -> None:
        self._body = body
        self._command = command_message(body)
        self._radio = RadioEncoder()

    def command(self, stamp_ns: int, command: Floats) -> bytes:
        """The bytes of `thruster_command`; `command` (actuators,), fractions."""
        return self._command.encode(stamp_ns, command[None, : len(self._body.actuators)])[0]

    def said(self, stamp_ns: int, row: Floats) -> bytes:
        """The bytes of what goes out over any medium; `row` (MESSAGE_SIZE,), see state.radio. No payload: silence."""
        message = RadioMessage(stamp_ns, self._body.frame, self._body.name, read_payload(row))
        return self._radio.message(message)
