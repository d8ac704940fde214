"""Small recordings of robots whose motion is known."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, split_topic

Floats = NDArray[np.float64]
EPOCH = 1_750_000_000 * 10**9  # ns, of all recordings here
FIELDS = {
    "pose": [f"pose.position.{axis}" for axis in "xyz"] + ["pose.orientation.z", "pose.orientation.w"],
    "compass": ["heading"],
    "pressure": ["fluid_pressure"],
    "imu": ["angular_velocity.z", *(f"linear_acceleration.{axis}" for axis in "xyz")],
    "illuminance": [],
    "velocity": [f"twist.linear.{axis}" for axis in "xyz"],
}


@dataclass(frozen=True)
class Topic:
    """What is recorded on one topic: stamps and log times (n,) [s since EPOCH], numbers (n, columns of FIELDS)."""

    stamp: Floats
    numbers: Floats
    log: Floats | None = None
    names: tuple[str, ...] = ("left", "right", "buoyancy")
    extra: Mapping[str, Any] | None = None

    def changed(self, **parts: Any) -> Topic:
        """The same with some parts replaced."""
        return replace(self, **parts)


def pose_numbers(x: Any, y: Any, z: Any, yaw: Any) -> Floats:
    """(n, 5) numbers of a pose."""
    columns = np.broadcast_arrays(x, y, z, np.sin(np.asarray(yaw) / 2), np.cos(np.asarray(yaw) / 2))
    return np.column_stack(columns)


def write_bag(path: Path, topics: Mapping[str, Topic]) -> Path:
    """A recording with these topics, by name (/lily_01/pose), in the order of their log times."""
    rows: list[tuple[int, str, int, bytes]] = []
    channels = []
    for name, topic in topics.items():
        kind = split_topic(name)[1]
        channels.append(Channel(name, ROBOT_TOPICS[kind].type_name))
        extra = dict(topic.extra or {})
        numbered = "value" if kind == "actuator_feedback" else "command"
        fields = FIELDS.get(kind, [f"{numbered}[{actuator}]" for actuator in topic.names])
        if kind == "thruster_command":
            extra |= {"name": list(topic.names), "command": [0.0] * len(topic.names)}
        template = PackedMessage([build(ROBOT_TOPICS[kind].type_name, extra)], fields)
        logs = topic.stamp if topic.log is None else topic.log
        for stamp, log, numbers in zip(topic.stamp, logs, topic.numbers, strict=True):
            data = template.encode(EPOCH + round(stamp * 1e9), numbers)[0]
            rows.append((EPOCH + round(log * 1e9), name, EPOCH + round(stamp * 1e9), data))
    with BagWriter(path, channels) as bag:
        for log, name, stamp, data in sorted(rows, key=lambda row: row[0]):
            bag.write(name, log, stamp, data)
    return path


def circling(duration: float = 40.0, rate: float = 10.0, seed: int = 0) -> dict[str, Topic]:
    """Lily on a circle of 0.5 m at 0.05 m/s, one turn every 63 s, without an IMU; millimetres of noise."""
    rng = np.random.default_rng(seed)
    time = np.arange(0.0, duration, 1.0 / rate)
    yaw = 0.1 * time
    place = 0.5 * np.sin(yaw), -0.5 * np.cos(yaw), np.full(time.size, -0.6)
    noisy = [column + 0.002 * rng.standard_normal(time.size) for column in place]
    commands = np.column_stack([0.5 + 0.1 * np.sin(time), 0.6 + 0.1 * np.sin(time), 0.1 * np.sign(np.sin(0.5 * time))])
    heading = (yaw + 0.02 * rng.standard_normal(time.size) + np.pi) % (2 * np.pi) - np.pi
    return {
        "/lily_01/pose": Topic(time, pose_numbers(*noisy, yaw)),
        "/lily_01/compass": Topic(time, heading[:, None]),
        "/lily_01/thruster_command": Topic(time, commands),
    }


@pytest.fixture(scope="session")
def lily_platform() -> Platform:
    """The platform of the contract."""
    return load_platform("lily")


@pytest.fixture
def record(tmp_path: Path) -> Callable[..., Path]:
    """A function that writes topics into a new recording."""
    return lambda topics, name="bag": write_bag(tmp_path / name, topics)


@pytest.fixture
def circle() -> dict[str, Topic]:
    """Topics of a robot that circles for 40 s."""
    return circling()


@pytest.fixture
def topic() -> type[Topic]:
    """What is recorded on one topic."""
    return Topic


@pytest.fixture
def poses() -> Callable[..., Floats]:
    """A function from x, y, z [m], yaw [rad] to the numbers of a pose topic."""
    return pose_numbers


def said(remarks: Sequence[str], *words: str) -> bool:
    """Whether one of the remarks holds all of these words."""
    return any(all(word in remark for word in words) for remark in remarks)


@pytest.fixture
def is_said() -> Callable[..., bool]:
    """A function from remarks and words: whether one remark holds them all."""
    return said


@dataclass(frozen=True)
class Swim:
    """How a robot of the contract's Lily is made and moved for a log; all off nominal unless said otherwise."""

    seed: int = 0
    duration: float = 300.0
    current: tuple[float, float] = (0.0, 0.0)  # m/s
    topics: tuple[str, ...] = ("pose", "compass", "pressure", "imu", "velocity")
    straight: bool = False  # no turning


def swimming_log(swim: Swim) -> RobotLog:
    """The log of a Lily that swims about at random: its own physics, by semi-implicit Euler steps of 0.05 s."""
    rng = np.random.default_rng(swim.seed)
    step, count = 0.05, int(swim.duration / 0.05)
    commands = _random_commands(rng, swim)
    held = np.repeat(commands, 2, axis=0)[:count]
    mass, inertia, drag, yaw_drag = np.array([0.44, 4.05e-4, 1.7778, 1.14e-4]) * rng.uniform(0.8, 1.25, 4)
    u = v = w = r = yaw = x = y = 0.0
    z = -1.0
    rows = []
    for left, right, pump in held.tolist():
        speed = math.sqrt(u * u + v * v)
        du = (0.005 * (left + right) - drag * speed * u) / mass + v * r
        dv = -drag * speed * v / mass - u * r
        dw = (0.0981 * pump - 1.7778 * abs(w) * w) / mass
        dr = (0.005 * 0.02497 * (right - left) - yaw_drag * abs(r) * r) / inertia
        rows.append((x, y, z, yaw, u, v, w, r, du - v * r, dv + u * r, dw))
        u, v, w, r = u + step * du, v + step * dv, w + step * dw, r + step * dr
        yaw += step * r
        x += step * (u * math.cos(yaw) - v * math.sin(yaw) + swim.current[0])
        y += step * (u * math.sin(yaw) + v * math.cos(yaw) + swim.current[1])
        z += step * w
    return _log(np.array(rows), commands, swim, rng)


def _random_commands(rng: np.random.Generator, swim: Swim) -> Floats:
    """(ticks of 0.1 s, 3) held for some seconds each: forward, turns, spins, reverse, coasts; the pump in pairs."""
    ticks = int(swim.duration / 0.1)
    commands = np.zeros((ticks, 3))
    place = 0
    while place < ticks:
        length = int(rng.uniform(20, 60))
        thrust, turn = rng.choice([0.0, 0.5, 0.9, 0.7, -0.4]), rng.choice([0.0, 0.0, 0.1, -0.1, 0.3, -0.3])
        turn *= not swim.straight
        commands[place : place + length, :2] = np.clip([thrust - turn, thrust + turn], -1.0, 1.0)
        half, pump = length // 2, rng.uniform(-0.08, 0.08)
        commands[place : place + half, 2] = pump
        commands[place + half : place + 2 * half, 2] = -pump
        place += length
    return commands


def _log(rows: Floats, commands: Floats, swim: Swim, rng: np.random.Generator) -> RobotLog:
    def noisy(every: int, columns: Floats, spread: Any) -> Stream:
        taken = columns[::every] + np.asarray(spread) * rng.standard_normal((len(columns[::every]), columns.shape[1]))
        return Stream(np.arange(len(taken)) * 0.05 * every, taken, np.broadcast_to(spread, columns.shape[1]) * 1.0)

    force = rows[:, 8:11] + np.array([0.0, 0.0, 9.81])
    streams = {
        "pose": noisy(2, rows[:, :4], [0.003, 0.003, 0.003, 0.02]),
        "compass": noisy(4, rows[:, 3:4] + 0.08 * np.sin(rows[:, 3:4] + 1.0) + 0.1, 0.03),
        "pressure": noisy(4, 101325.0 + 300.0 - 9810.0 * rows[:, 2:3], 15.0),
        "imu": noisy(1, np.hstack([rows[:, 7:8] + 0.01, force]), [0.01, 0.03, 0.03, 0.03]),
        "velocity": noisy(4, rows[:, 4:7], 0.003),
    }
    kept = {name: stream for name, stream in streams.items() if name in swim.topics}
    return RobotLog("lily_01", np.arange(len(commands)) * 0.1, commands, kept)


_swum = cache(swimming_log)


@pytest.fixture
def swim() -> type[Swim]:
    """How a robot is moved for a log."""
    return Swim


@pytest.fixture
def swum() -> Callable[[Swim], RobotLog]:
    """A function from how a robot is moved to its log."""
    return _swum
