"""Alters the logs of a recording in a known way and seals what was done: concealment on real noise.

The water, the robot and the noise stay what they were; the unaltered recording is its own control, and figures are to
be reported as differences from it.
"""

from __future__ import annotations

import json
import math
import secrets
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.interfaces import Connection
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from concealer.bag import new_writer
from concealer.seal import canonical, file_digest, publish, seal

AIR = 101325.0  # Pa, of the contract
Message = Any
Change = Callable[[Message, float], Message | None]  # message, time since its stream's first [s] -> message, None: gone


def stamp_of(message: Message) -> int:
    """Header stamp [ns]."""
    return int(message.header.stamp.sec) * 10**9 + int(message.header.stamp.nanosec)


def move_stamp(message: Message, ns: int) -> None:
    """Moves the header stamp."""
    total = stamp_of(message) + ns
    message.header.stamp.sec, message.header.stamp.nanosec = total // 10**9, total % 10**9


def gain_change(index: int, factor: float) -> Change:
    """One actuator's logged command times a factor."""

    def change(message: Message, _time: float) -> Message:
        message.command = np.array(message.command)
        message.command[index] *= factor
        if abs(message.command[index]) > 1.0:
            raise ValueError(f"times {factor:g} a command is more than full: who reads the log takes it for full")
        return message

    return change


def delay_change(latency: float, skew: float = 0.0) -> Change:
    """Stamps that are late, or run fast."""

    def change(message: Message, time: float) -> Message:
        move_stamp(message, round(1e9 * (latency + skew * time)))
        return message

    return change


def compass_change(amount: float) -> Change:
    """reading + amount/2 + amount sin(reading)."""

    def change(message: Message, _time: float) -> Message:
        heading = message.heading + 0.5 * amount + amount * math.sin(message.heading)
        message.heading = math.atan2(math.sin(heading), math.cos(heading))
        return message

    return change


def scale_change(factor: float) -> Change:
    """Positions times a factor."""

    def change(message: Message, _time: float) -> Message:
        place = message.pose.position
        place.x, place.y, place.z = factor * place.x, factor * place.y, factor * place.z
        return message

    return change


def smooth_change(tau: float, indices: tuple[int, ...]) -> Change:
    """Logged commands behind a first-order low-pass."""
    state: dict[int, float] = {}
    last = [0.0]

    def change(message: Message, time: float) -> Message:
        share = -math.expm1(-max(time - last[0], 0.0) / tau)
        last[0] = time
        message.command = np.array(message.command)
        for k in indices:
            value = float(message.command[k])
            state[k] = state.get(k, value) + share * (value - state.get(k, value))
            message.command[k] = state[k]
        return message

    return change


def mirror_change(_amount: float) -> Change:
    """A compass that counts the other way round."""

    def change(message: Message, _time: float) -> Message:
        message.heading = -message.heading
        return message

    return change


def gyro_change(bias: float) -> Change:
    """A gyroscope with a bias about the vertical."""

    def change(message: Message, _time: float) -> Message:
        message.angular_velocity.z += bias
        return message

    return change


def gyro_scale_change(factor: float) -> Change:
    """A gyroscope that shows turns too large by a factor."""

    def change(message: Message, _time: float) -> Message:
        message.angular_velocity.z *= factor
        return message

    return change


def offset_change(amount: float) -> Change:
    """A pressure that reads too high."""

    def change(message: Message, _time: float) -> Message:
        message.fluid_pressure += amount
        return message

    return change


def heading_change(amount: float) -> Change:
    """A compass mounted askew: reading + amount."""

    def change(message: Message, _time: float) -> Message:
        heading = message.heading + amount
        message.heading = math.atan2(math.sin(heading), math.cos(heading))
        return message

    return change


def drift_change(rate: float) -> Change:
    """A pressure that creeps."""

    def change(message: Message, time: float) -> Message:
        message.fluid_pressure += rate * time
        return message

    return change


def pressure_gain_change(factor: float) -> Change:
    """A gauge that shows the weight of the water wrong by a factor; air is right."""

    def change(message: Message, _time: float) -> Message:
        message.fluid_pressure = AIR + factor * (message.fluid_pressure - AIR)
        return message

    return change


def hidden_change(_amount: float) -> Change:
    """A stream that was not recorded."""
    return lambda message, _time: None


def axis_change(_amount: float) -> Change:
    """Poses whose y counts the other way."""

    def change(message: Message, _time: float) -> Message:
        message.pose.position.y = -message.pose.position.y
        return message

    return change


def right_down_change(_amount: float) -> Change:
    """Velocities forward-right-down."""

    def change(message: Message, _time: float) -> Message:
        linear = message.twist.linear
        linear.y, linear.z = -linear.y, -linear.z
        return message

    return change


def swapped_change(_amount: float) -> Change:
    """Velocities whose x and y stand in each other's place."""

    def change(message: Message, _time: float) -> Message:
        linear = message.twist.linear
        linear.x, linear.y = linear.y, linear.x
        return message

    return change


def degrees_change(_amount: float) -> Change:
    """A gyroscope in degrees per second."""

    def change(message: Message, _time: float) -> Message:
        message.angular_velocity.z = math.degrees(message.angular_velocity.z)
        return message

    return change


def earth_change(moments: list[float], headings: list[float]) -> Change:
    """Velocities along the axes of the world; headings [rad] at header stamps `moments` [s], ascending."""

    def change(message: Message, _time: float) -> Message:
        heading, linear = float(np.interp(1e-9 * stamp_of(message), moments, headings)), message.twist.linear
        sine, cosine = math.sin(heading), math.cos(heading)
        linear.x, linear.y = cosine * linear.x - sine * linear.y, sine * linear.x + cosine * linear.y
        return message

    return change


def headings_of(source: Path, topic: str) -> tuple[list[float], list[float]]:
    """Header stamps [s] of a robot's poses, and their headings [rad], unwrapped."""
    found = {}
    with Reader(source) as reader:
        store = store_of(list(reader.connections))
        for link, _logged, data in reader.messages([link for link in reader.connections if link.topic == topic]):
            message = store.deserialize_cdr(data, link.msgtype)
            turn = message.pose.orientation
            sine, cosine = 2.0 * (turn.w * turn.z + turn.x * turn.y), 1.0 - 2.0 * (turn.y**2 + turn.z**2)
            found[1e-9 * stamp_of(message)] = math.atan2(sine, cosine)
    moments = sorted(found)
    return moments, np.unwrap([found[moment] for moment in moments]).tolist()


def plan(how: str, amount: float) -> tuple[str, Change, dict[str, Any]]:
    """Topic to alter, how to alter a message, and the truth; `how` may end in :topic or :actuator number.

    gain:K       logged command of actuator K times (1 + amount); K = 0 is left
    delay:TOPIC  stamps late by amount [s]
    skew:TOPIC   stamps run fast by amount [s/s]
    compass      reading + amount/2 + amount sin(reading) [rad]
    scale        positions times (1 + amount)
    lowpass      logged thruster commands behind a low-pass of amount [s]: the thrust leads the log
    mirror       reading of the compass with its sign changed; the amount says nothing
    gyro         turn rate about the vertical plus amount [rad/s]
    drift        pressure plus amount [Pa/s] times the time
    pressure     pressure plus amount [Pa]
    gyroscale    turn rate about the vertical times (1 + amount)
    heading      reading of the compass plus amount [rad]
    pressuregain pressure of the water times (1 + amount)
    hidden:TOPIC all messages left out
    axis         y of the positions with its sign changed
    rightdown    y and z of the velocities with their signs changed
    swapped      x and y of the velocities in each other's place
    degrees      turn rate in degrees per second
    earth        velocities along the axes of the world
    """
    kind, _, detail = how.partition(":")
    ways: dict[str, Callable[[], tuple[str, Change, dict[str, Any]]]] = {
        "gain": lambda: _gain_plan(int(detail or 0), amount),
        "delay": lambda: (detail, delay_change(amount), _told("sensor_latency", latency=amount)),
        "skew": lambda: (detail, delay_change(0.0, amount), _told("clock_skew", skew=amount)),
        "compass": lambda: (
            "compass", compass_change(amount), _told("compass_distortion", offset=0.5 * amount, sin=amount, cos=0.0),
        ),
        "scale": lambda: ("pose", scale_change(1.0 + amount), _told("camera_scale", scale=1.0 + amount)),
        "lowpass": lambda: (
            "thruster_command", smooth_change(amount, (0, 1)),
            _told("thruster_lag", time_constant=-amount) | {"tolerated": ["sensor_latency"]},
        ),
        "mirror": lambda: ("compass", mirror_change(amount), _told("frame_mixup", correction="negate the reading")),
        "gyro": lambda: ("imu", gyro_change(amount), _told("imu_bias", gyro_z=amount)),
        "pressure": lambda: ("pressure", offset_change(amount), _told("pressure_offset", offset=amount)),
        "gyroscale": lambda: ("imu", gyro_scale_change(1.0 + amount), _told("gyro_scale", scale=1.0 + amount)),
        "heading": lambda: (
            "compass", heading_change(amount), _told("compass_distortion", offset=amount, sin=0.0, cos=0.0),
        ),
        "drift": lambda: ("pressure", drift_change(amount), _told("pressure_drift", rate=amount)),
        "pressuregain": lambda: (
            "pressure", pressure_gain_change(1.0 + amount), _told("pressure_gain", gain=1.0 + amount),
        ),
        "hidden": lambda: (detail, hidden_change(amount), _told("nothing")),
        "axis": lambda: ("pose", axis_change(amount), _told("frame_mixup", correction="y of the poses")),
        "rightdown": lambda: ("velocity", right_down_change(amount), _told("frame_mixup", correction="y and z")),
        "swapped": lambda: ("velocity", swapped_change(amount), _told("frame_mixup", correction="x and y")),
        "degrees": lambda: ("imu", degrees_change(amount), _told("frame_mixup", correction="radians")),
        "earth": lambda: ("velocity", earth_change([0.0], [0.0]), _told("frame_mixup", correction="body axes")),
    }  # fmt: skip
    if kind not in ways:
        raise ValueError(f"{how} is not a way to tamper; there are {', '.join(ways)}")
    return ways[kind]()


def _told(name: str, **parameters: float | str) -> dict[str, Any]:
    return {"id": name, "parameters": parameters}


def _gain_plan(index: int, amount: float) -> tuple[str, Change, dict[str, Any]]:
    # What the log exaggerates, the thruster lacks.
    left, right = (1.0 / (1.0 + amount), 1.0) if index == 0 else (1.0, 1.0 / (1.0 + amount))
    truth = _told("thruster_asymmetry", difference=2.0 * (right - left) / (right + left))
    return "thruster_command", gain_change(index, 1.0 + amount), truth


def store_of(connections: list[Connection]) -> Any:
    """Message types of ROS 2 and those that the recording brings along."""
    store = get_typestore(Stores.ROS2_JAZZY)
    for link in connections:
        if link.msgtype not in store.types:
            text = link.msgdef.data
            store.register({k: v for k, v in get_types_from_msg(text, link.msgtype).items() if k not in store.types})
    return store


def copy(source: Path, target: Path, topic: str, change: Change) -> int:
    """Copies a recording with the messages of one topic changed; returns how many those were."""
    changed, first = 0, None
    with Reader(source) as reader, new_writer(target) as writer:
        store = store_of(list(reader.connections))
        links = {
            link.id: writer.add_connection(link.topic, link.msgtype, typestore=store) for link in reader.connections
        }
        for link, logged, data in reader.messages():
            body = data
            if link.topic == topic:
                message = store.deserialize_cdr(data, link.msgtype)
                first = stamp_of(message) if first is None else first
                message = change(message, 1e-9 * (stamp_of(message) - first))
                changed += 1
                if message is None:
                    continue
                body = bytes(store.serialize_cdr(message, link.msgtype))
            writer.write(links[link.id], logged, body)
    return changed


def tamper(source: Path, out: Path, how: str, amount: float, robot: str | None = None) -> str:
    """Writes OUT/recordings/NAME, OUT/envelopes/NAME.json and the ledger; says what was done.

    Raises ValueError if the recording has no such robot or topic, FileExistsError if `out` holds a trial.
    """
    name = source.name.removesuffix(".mcap")
    topic, change, truth = plan(how, amount)
    with Reader(source) as reader:
        topics = sorted(link.topic for link in reader.connections if link.topic.endswith(f"/{topic}"))
    wanted = [full for full in topics if robot is None or full == f"/{robot.strip('/')}/{topic}"]
    if not wanted:
        raise ValueError(f"{source} has no topic {topic} of {robot or 'any robot'}; it has {topics or 'none'}")
    if how == "earth":
        change = earth_change(*headings_of(source, wanted[0].replace("/velocity", "/pose")))
    (out / "envelopes").mkdir(parents=True)
    (out / "recordings").mkdir()
    count = copy(source, out / "recordings" / name, wanted[0], change)
    victim = wanted[0].strip("/").rpartition("/")[0]
    effect: dict[str, Any] = {
        "topic": None if topic == "thruster_command" else topic,
        "form": how,
        "robots": [victim],
        "size": amount,
    }
    effect |= {"large": 1.0, "unit": "", "shared": False, "acceptable": [], "tolerated": []} | truth
    # A noise of -1 says: real, unknown.
    envelope = {
        "recording": name, "kind": "single", "effects": [effect], "noise": -1.0, "oracle": {}, "control": str(source),
        "expected_verdicts": ["mismatch"], "salt": secrets.token_hex(16),
    }  # fmt: skip
    (out / "envelopes" / f"{name}.json").write_bytes(canonical(envelope))
    entry = {"envelope": seal(envelope), "recording": file_digest(out / "recordings" / name / f"{name}.mcap")}
    publish(out, {name: entry})
    return json.dumps({"recording": name, "topic": wanted[0], "messages": count, **truth})
