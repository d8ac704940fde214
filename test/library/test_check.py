"""The first look at any robot's recording: a sound one passes, and each thing that is broken is named."""

from __future__ import annotations

import copy
import functools
import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog
from cocorosim_ros.diagnosis.checking.units import check_units
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store

START = 1_700_000_000.0  # s
ODOMETRY, IMU, PRESSURE, TF = "/odometry", "/imu/data", "/pressure", "/tf"
TYPES = {
    ODOMETRY: "nav_msgs/msg/Odometry",
    IMU: "sensor_msgs/msg/Imu",
    PRESSURE: "sensor_msgs/msg/FluidPressure",
    TF: "tf2_msgs/msg/TFMessage",
    "/tf_static": "tf2_msgs/msg/TFMessage",
}
LATE = 0.01  # s at least from a stamp to the time of recording
RATE, SPEED, CLIMB = 0.3, 0.4, 0.2  # rad/s, m/s, amplitude of the rate of climb over RATE [m]
Log = dict[str, list[tuple[float, Any]]]  # by topic: time of recording [s] and message


def stamp(time: float) -> Any:
    """A time [s] since the start as a message."""
    seconds = START + time
    whole = math.floor(seconds)
    return type_store.build("builtin_interfaces/msg/Time", {"sec": whole, "nanosec": round((seconds - whole) * 1e9)})


def header(time: float, frame: str) -> Any:
    """A header."""
    return type_store.build("std_msgs/msg/Header", {"stamp": stamp(time), "frame_id": frame})


def heading(time: float) -> float:
    """The vehicle swings to and fro while it turns [rad]."""
    return RATE * time + 0.8 * math.sin(0.9 * time)


def turning(time: float) -> float:
    """Its derivative [rad/s]."""
    return RATE + 0.72 * math.cos(0.9 * time)


def depth(time: float) -> float:
    """How deep it is [m]."""
    return 1.5 + CLIMB * math.sin(0.4 * time)


def attitude(yaw: float) -> dict[str, float]:
    """The quaternion of an upright vehicle."""
    return {"x": 0.0, "y": 0.0, "z": math.sin(yaw / 2), "w": math.cos(yaw / 2)}


def transform(time: float, parent: str, child: str, place: tuple[float, float, float], yaw: float) -> dict[str, Any]:
    """One transform of a TFMessage."""
    translation = dict(zip("xyz", place, strict=True))
    moved = {"translation": translation, "rotation": attitude(yaw)}
    return {"header": header(time, parent), "child_frame_id": child, "transform": moved}


@functools.cache
def sound_log() -> Log:
    """Half a minute of a vehicle with odometry, IMU, pressure and transforms, with noise, and nothing wrong."""
    draw = np.random.default_rng(5)
    place, log = np.zeros(2), Log()
    diagonal = (np.eye(6) * 0.01).ravel()
    for tick in range(1600):
        time = tick / 50
        place = place + 0.02 * SPEED * np.array([math.cos(heading(time)), math.sin(heading(time))])
        noise, late = draw.normal(0.0, 0.004, 9), LATE + draw.exponential(0.001)
        if tick % 2 == 0:
            felt = {"x": noise[0], "y": noise[1], "z": 9.81 + noise[2]}
            values = {
                "header": header(time, "imu_link"),
                "orientation": attitude(heading(time) + noise[3]),
                "angular_velocity": {"x": noise[4], "y": noise[5], "z": turning(time) + noise[6]},
                "linear_acceleration": felt,
            }
            log.setdefault(IMU, []).append((time + late, type_store.build(TYPES[IMU], values)))
        if tick % 5 == 0:
            where = {"x": place[0] + noise[0], "y": place[1] + noise[1], "z": -depth(time) + noise[2]}
            pose = {"pose": {"position": where, "orientation": attitude(heading(time))}, "covariance": diagonal}
            speed = {
                "linear": {"x": SPEED + noise[7], "y": noise[8], "z": 0.0},
                "angular": {"x": 0.0, "y": 0.0, "z": turning(time)},
            }
            twist = {"twist": speed, "covariance": diagonal.copy()}
            values = {"header": header(time, "odom"), "child_frame_id": "base_link", "pose": pose, "twist": twist}
            log.setdefault(ODOMETRY, []).append((time + late, type_store.build(TYPES[ODOMETRY], values)))
            moved = transform(time, "odom", "base_link", (place[0], place[1], -depth(time)), heading(time))
            log.setdefault(TF, []).append((time + late, type_store.build(TYPES[TF], {"transforms": [moved]})))
        if tick % 10 == 0:
            pressure = 101325.0 + 9810.0 * depth(time) + 20.0 * noise[0]
            values = {"header": header(time, "base_link"), "fluid_pressure": pressure, "variance": 4.0}
            log.setdefault(PRESSURE, []).append((time + late, type_store.build(TYPES[PRESSURE], values)))
    fixed = transform(0.0, "base_link", "imu_link", (0.1, 0.0, 0.0), 0.0)
    log["/tf_static"] = [(0.0, type_store.build(TYPES[TF], {"transforms": [fixed]}))]
    return log


def measured(message: Any) -> float:
    """The stamp of a message [s since the start]."""
    head = message.header if hasattr(message, "header") else message.transforms[0].header
    return float(head.stamp.sec - START + 1e-9 * head.stamp.nanosec)


def moved_stamps(log: Log, topic: str, change: Callable[[float], float | None]) -> None:
    """Give the messages of a topic other stamps [s since the start]; None for the stamp zero."""
    for _, message in log[topic]:
        time = change(measured(message))
        for head in [message.header] if hasattr(message, "header") else [each.header for each in message.transforms]:
            head.stamp = type_store.build("builtin_interfaces/msg/Time") if time is None else stamp(time)


def each_message(log: Log, topic: str, change: Callable[[Any], None]) -> None:
    """Change every message of a topic."""
    for _, message in log[topic]:
        change(message)


@pytest.fixture
def checked(tmp_path: Path) -> Callable[[Log], SimpleNamespace]:
    """Function of a log: its findings by kind and all sentences, after it was written as a bag and read again."""

    def run(log: Log) -> SimpleNamespace:
        channels = [Channel(topic, TYPES.get(topic, "sensor_msgs/msg/Imu")) for topic in log]
        every = sorted((time, topic, row) for topic, rows in log.items() for row, (time, _) in enumerate(rows))
        with BagWriter(tmp_path / "bag", channels) as writer:
            for time, topic, row in every:
                logged = round((START + time) * 1e9)
                writer.write(topic, logged, logged, type_store.serialize(log[topic][row][1]))
        result = cocorosim.check(tmp_path / "bag")
        words = " ".join(each.sentence for each in result.findings)
        return SimpleNamespace(result=result, kinds={each.kind for each in result.findings}, words=words)

    return run


def test_a_sound_recording_of_standard_messages_passes(checked: Callable[[Log], SimpleNamespace]) -> None:
    """Nothing is said of noise, motion and transforms that are as they should be."""
    found = checked(sound_log())
    assert found.result.findings == ()
    assert {name for name, _, _ in found.result.topics} == set(TYPES)


def test_a_sound_recording_of_ours_passes(tmp_path: Path) -> None:
    """Neither readings without noise nor controllers that repeat themselves are odd."""
    cocorosim.record("one_lily", tmp_path / "bag", duration="20 s")
    assert cocorosim.check(tmp_path / "bag").findings == ()


def _scaled(attribute: str, factor: float) -> Callable[[Any], None]:
    def change(message: Any) -> None:
        vector = getattr(message, attribute)
        vector.x, vector.y, vector.z = factor * vector.x, factor * vector.y, factor * vector.z

    return change


def _in_world(message: Any) -> None:
    turn, speed = message.pose.pose.orientation, message.twist.twist.linear
    yaw = 2.0 * math.atan2(turn.z, turn.w)
    speed.x, speed.y = (
        math.cos(yaw) * speed.x - math.sin(yaw) * speed.y,
        math.sin(yaw) * speed.x + math.cos(yaw) * speed.y,
    )


def _twice(log: Log, **other: Any) -> None:
    """A second publisher of base_link."""
    doubled = []
    for logged, message in log[TF]:
        first = message.transforms[0]
        place = first.transform.translation
        again = transform(
            measured(message), other.get("parent", "odom"), "base_link", (place.x + 0.5, place.y, place.z), 0.0
        )
        doubled += [(logged, message), (logged + 0.001, type_store.build(TYPES[TF], {"transforms": [again]}))]
    log[TF] = doubled


def _frozen(log: Log) -> None:
    still = log[IMU][200][1]
    for _, message in log[IMU][200:350]:
        message.orientation, message.angular_velocity = still.orientation, still.angular_velocity
        message.linear_acceleration = still.linear_acceleration


def _negative(message: Any) -> None:
    message.pose.covariance[7] = -0.01


def _lopsided(message: Any) -> None:
    message.twist.covariance[1] = 0.004


def _indefinite(message: Any) -> None:
    message.pose.covariance[1] = message.pose.covariance[6] = 0.5


def _other_order(message: Any) -> None:
    turn = message.orientation
    turn.x, turn.y, turn.z, turn.w = turn.w, turn.x, turn.y, turn.z


def _none(message: Any) -> None:
    message.orientation.z = message.orientation.w = 0.0


def _set(path: str, change: Callable[[float], float]) -> Callable[[Any], None]:
    *owners, name = path.split(".")

    def run(message: Any) -> None:
        for owner in owners:
            message = getattr(message, owner)
        setattr(message, name, change(getattr(message, name)))

    return run


def _thinned(log: Log) -> None:
    log[IMU] = [pair for row, pair in enumerate(log[IMU]) if not 250 <= row < 450 or row % 4 == 0]


def _hole(log: Log) -> None:
    log[ODOMETRY] = log[ODOMETRY][:101] + log[ODOMETRY][150:]


BROKEN: dict[str, tuple[Callable[[Log], Any], str, str]] = {
    "time runs backwards": (
        lambda log: moved_stamps(log, IMU, lambda time: time - 0.3 if 10.0 < time < 10.1 else time),
        "stamps",
        "time runs backwards",
    ),
    "stamps of zero": (
        lambda log: moved_stamps(log, PRESSURE, lambda time: None),
        "stamps",
        "all messages have the stamp zero",
    ),
    "another clock": (lambda log: moved_stamps(log, PRESSURE, lambda time: time - 3000.0), "clock", "/pressure"),
    "a clock that runs fast": (
        lambda log: moved_stamps(log, IMU, lambda time: 1.001 * time),
        "clock",
        "ppm fast",
    ),
    "a gap": (_hole, "rate", "a gap from 10.0 to 15.0 s"),
    "a rate that drops": (_thinned, "rate", "/imu/data: its rate drops from 25 to 6.25 Hz"),
    "a frozen instrument": (_frozen, "frozen", "150 messages in a row say the same, from 8.0 to 14.0 s"),
    "two publishers of a frame": (_twice, "frames", "have one stamp and say different things"),
    "two parents of a frame": (lambda log: _twice(log, parent="map"), "frames", "2 parents, map and odom"),
    "transforms that lag": (
        lambda log: moved_stamps(log, TF, lambda time: time - 0.5),
        "frames",
        "stamps 0.5 s before",
    ),
    "a lost tf_static": (
        lambda log: log.pop("/tf_static"),
        "frames",
        "imu_link (/imu/data), and /tf_static was not recorded",
    ),
    "a negative variance": (
        lambda log: each_message(log, ODOMETRY, _negative),
        "covariance",
        "negative variance in every",
    ),
    "a lopsided covariance": (
        lambda log: each_message(log, ODOMETRY, _lopsided),
        "covariance",
        "twist.covariance is not symmetric",
    ),
    "no covariance": (lambda log: each_message(log, ODOMETRY, _indefinite), "covariance", "not positive semi-definite"),
    "g": (lambda log: each_message(log, IMU, _scaled("linear_acceleration", 1 / 9.81)), "units", "it is in g"),
    "no gravity": (
        lambda log: each_message(log, IMU, _set("linear_acceleration.z", lambda z: z - 9.81)),
        "units",
        "gravity is left out",
    ),
    "z down": (lambda log: each_message(log, IMU, _scaled("linear_acceleration", -1.0)), "units", "z is down"),
    "degrees": (
        lambda log: each_message(log, IMU, _set("angular_velocity.z", math.degrees)),
        "units",
        "it is in degrees",
    ),
    "a turned sign": (
        lambda log: each_message(log, IMU, _set("angular_velocity.z", lambda rate: -rate)),
        "units",
        "its sign or its axes are turned",
    ),
    "twist of the world": (lambda log: each_message(log, ODOMETRY, _in_world), "units", "in the axes of the world"),
    "millimetres": (
        lambda log: each_message(log, ODOMETRY, lambda message: _scaled("linear", 1e3)(message.twist.twist)),
        "units",
        "unit or scale",
    ),
    "hectopascal": (
        lambda log: each_message(log, PRESSURE, _set("fluid_pressure", lambda value: value / 100)),
        "units",
        "in hPa",
    ),
    "depth for z": (
        lambda log: each_message(log, ODOMETRY, _set("pose.pose.position.z", lambda z: -z)),
        "units",
        "z grows with the pressure",
    ),
    "w first": (lambda log: each_message(log, IMU, _other_order), "units", "x, y, z, w are in another order"),
    "no attitude": (lambda log: each_message(log, IMU, _none), "units", "quaternions of orientation are zero"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_each_thing_that_is_broken_is_named(name: str, checked: Callable[[Log], SimpleNamespace]) -> None:
    """One thing is broken in a sound recording: its kind is found, and a sentence names it."""
    log = copy.deepcopy(sound_log())
    broken, kind, words = BROKEN[name]
    broken(log)
    found = checked(log)
    assert kind in found.kinds, found.words
    assert words in found.words


@pytest.mark.parametrize("noise", [0.0, 0.01])
def test_a_pose_made_of_degrees(noise: float) -> None:
    """A vehicle that swings by 60 degrees to and fro: its track turns as it does, or 57 times less."""
    draw = np.random.default_rng(3)
    time = np.arange(0.0, 90.0, 0.1)
    yaw = 1.0 * np.sin(0.3 * time)
    place = np.cumsum(0.1 * np.array([np.cos(yaw), np.sin(yaw)]), axis=1) + draw.normal(0.0, noise, (2, time.size))
    upright = np.zeros(time.size)
    columns = [f"pose.position.{axis}" for axis in "xyz"] + [f"pose.orientation.{axis}" for axis in "xyzw"]
    found = []
    for recorded in (yaw, np.degrees(yaw)):
        turn = [upright, upright, np.sin(recorded / 2), np.cos(recorded / 2)]
        values = np.column_stack([*place, upright, *turn])
        at = np.array(time * 1e9, dtype=np.int64)
        topic = TopicLog("/boat/pose", "geometry_msgs/msg/PoseStamped", at, at, at, tuple(columns), values)
        found.append([each.sentence for each in check_units(topic)])
    assert found[0] == []
    assert len(found[1]) == 1
    assert "as its track does: it was made of degrees taken for radians" in found[1][0]


def test_a_recording_that_is_none(tmp_path: Path) -> None:
    """What is no bag is said in a sentence."""
    (tmp_path / "notes.mcap").write_text("nothing of the kind")
    with pytest.raises(cocorosim.CocorosimError, match=r"notes\.mcap"):
        cocorosim.check(tmp_path / "notes.mcap")
