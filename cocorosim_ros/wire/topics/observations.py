"""From the bytes of one robot's topics to what its controller sees, and from its answer to bytes."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.cdr.neighbours import read_neighbours
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.radio_messages import RadioEncoder, RadioMessage, hear
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.swarm_messages import (
    command_message,
    compass_message,
    concentration_message,
    illuminance_message,
    imu_message,
    pressure_message,
    scan_message,
    velocity_message,
)
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, PAYLOAD_LIMIT


class ObservationDecoder:
    """Turns the latest bytes of each topic of one robot into its Observation; absent topics read as NaN.

    A blue-light sensor that is not in the message reads as +inf: it sees nothing.
    """

    def __init__(self, body: BodyDescription, hearing_limit: int) -> None:
        self._sensors = len(body.sensors)
        self._heard = np.zeros((hearing_limit, MESSAGE_SIZE))
        self._light = np.zeros((hearing_limit, MESSAGE_SIZE))
        self._offset = np.zeros((hearing_limit, 3))
        self._velocity = np.zeros((hearing_limit, 3))
        self._numbers: dict[str, PackedMessage] = {
            "compass": compass_message([body]),
            "pressure": pressure_message([body]),
            "imu": imu_message([body]),
            "velocity": velocity_message([body]),
            "illuminance": illuminance_message([body]),
            "concentration": concentration_message([body]),
        }
        if body.sensors:
            self._numbers["blss"] = scan_message([body])

    def observation(self, time: float, latest: dict[str, bytes]) -> Observation:
        """What the robot knows at `time` [s]. Raises CocorosimError for bytes that hold something else."""
        inertial = self._read("imu", latest, 6)
        ranges = self._read("blss", latest, 2 * self._sensors)
        ranges = np.where(np.isnan(ranges), np.inf, ranges)
        return Observation(
            time=time,
            compass=float(self._read("compass", latest, 1)[0]),
            pressure=float(self._read("pressure", latest, 1)[0]),
            angular_rate=inertial[:3],
            specific_force=inertial[3:],
            velocity=self._read("velocity", latest, 4),
            neighbour_range=ranges[: self._sensors],
            obstacle_range=ranges[self._sensors :],
            heard_count=hear(latest.get("radio_rx"), self._heard),
            heard=self._heard,
            light_count=hear(latest.get("blue_light_rx"), self._light),
            light=self._light,
            neighbour_count=self._look_around(latest.get("neighbours")),
            neighbour_offset=self._offset,
            neighbour_velocity=self._velocity,
            illuminance=float(self._read("illuminance", latest, 1)[0]),
            concentration=float(self._read("concentration", latest, 1)[0]),
        )

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


def write_payload(row: Floats, payload: tuple[float, ...]) -> None:
    """Put a radio payload into a row of state.radio; what exceeds PAYLOAD_LIMIT numbers is cut off."""
    kept = payload[:PAYLOAD_LIMIT]
    row[MESSAGE_LENGTH] = len(kept)
    row[1 : 1 + len(kept)] = kept
    row[1 + len(kept) :] = 0.0


def read_payload(row: Floats) -> tuple[float, ...]:
    """The radio payload in a row of state.radio."""
    return tuple(row[1 : 1 + int(row[MESSAGE_LENGTH])].tolist())


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
        """The bytes of `radio_tx` or `blue_light_tx`; `row` (MESSAGE_SIZE,), see state.radio. No payload: silence."""
        message = RadioMessage(stamp_ns, self._body.frame, self._body.name, read_payload(row))
        return self._radio.message(message)
