"""Logs of a vehicle on a circle, whose motion is a closed form: the map that is guessed makes that motion of them."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.guessing.guess import _pattern
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.library.convert import convert
from cocorosim_ros.library.guess import guess
from cocorosim_ros.library.recording import Recording
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store

RADIUS, TURNING, SINKING = 2.0, 0.3, 0.05  # m, rad/s, m/s
TICK, COUNT = 0.1, 400
TIME = TICK * np.arange(COUNT)
YAW = TURNING * TIME + math.pi / 2
X, Y, DEPTH = RADIUS * np.cos(TURNING * TIME), RADIUS * np.sin(TURNING * TIME), 0.5 + SINKING * TIME
SPEED = RADIUS * TURNING
LEFT, RIGHT = 0.5 + 0.25 * np.sin(TIME), 0.5 - 0.25 * np.sin(TIME)
SEA = 101_325.0 + 9810.0 * DEPTH  # Pa: whatever the water weighs, it grows with the depth
Converted = Callable[[Path], tuple[Recording, tuple[str, ...]]]


@pytest.fixture
def converted(tmp_path: Path) -> Converted:
    """A function of a log: the recording that the guessed map makes of it, and the doubts."""

    def run(log: Path) -> tuple[Recording, tuple[str, ...]]:
        doubts = guess(log, tmp_path / "guessed.yaml").doubts
        return convert(tmp_path / "guessed.yaml", log, tmp_path / "out").recordings[0].read(), doubts

    return run


def assert_circle(recording: Recording, robot: str) -> None:
    """The track of the robot is the circle, its axes those of REP 103."""
    track = recording.tracks[robot]
    assert len(track.position) == COUNT
    assert track.position == pytest.approx(np.column_stack([X, Y, -DEPTH]), abs=1e-3)
    assert np.exp(1j * track.yaw) == pytest.approx(np.exp(1j * YAW), abs=1e-3)


def column(recording: Recording, robot: str, topic: str, name: str) -> Any:
    """(n,) one number of one topic."""
    return recording.readings[robot][topic].column(name)


def vector(*numbers: float) -> dict[str, float]:
    """A Vector3 or Point."""
    return dict(zip("xyz", numbers, strict=True))


def heading(angle: float) -> dict[str, float]:
    """A quaternion about z."""
    return {"z": math.sin(angle / 2), "w": math.cos(angle / 2)}


def write_bag(folder: Path, topics: dict[str, tuple[str, Callable[[int], dict[str, Any]]]]) -> None:
    """A bag with a message of each topic every tick; those with a header have its stamp."""
    with BagWriter(folder, [Channel(topic, kind) for topic, (kind, _) in topics.items()]) as writer:
        for row in range(COUNT):
            at = 10**9 + row * 10**8
            stamp = {"stamp": {"sec": at // 10**9, "nanosec": at % 10**9}, "frame_id": "odom"}
            for topic, (kind, content) in topics.items():
                fields = content(row)
                if "header" in fields:
                    fields["header"] = stamp
                writer.write(topic, at, at, type_store.serialize(type_store.build(kind, fields)))


def odometry(row: int) -> dict[str, Any]:
    """The circle as nav_msgs/Odometry."""
    pose = {"position": vector(X[row], Y[row], -DEPTH[row]), "orientation": heading(YAW[row])}
    twist = {"linear": vector(SPEED, 0.0, -SINKING), "angular": vector(0.0, 0.0, TURNING)}
    return {"header": {}, "pose": {"pose": pose}, "twist": {"twist": twist}}


def odometry_down(row: int) -> dict[str, Any]:
    """The same in north-east-down: x is north, y east, and yaw counts clockwise from north."""
    pose = {"position": vector(Y[row], X[row], DEPTH[row]), "orientation": heading(math.pi / 2 - YAW[row])}
    twist = {"linear": vector(SPEED, 0.0, SINKING), "angular": vector(0.0, 0.0, -TURNING)}
    return {"header": {}, "pose": {"pose": pose}, "twist": {"twist": twist}}


def imu(row: int) -> dict[str, Any]:
    """What an IMU shows that lies flat: gravity upwards and the turning."""
    return {
        "header": {},
        "linear_acceleration": vector(0.0, RADIUS * TURNING**2, 9.81),
        "angular_velocity": vector(0.0, 0.0, TURNING),
        "orientation": heading(YAW[row]),
    }


def pressure(row: int) -> dict[str, Any]:
    """What a pressure sensor shows."""
    return {"header": {}, "fluid_pressure": SEA[row]}


ODOMETRY, FLUID, FLOAT = "nav_msgs/msg/Odometry", "sensor_msgs/msg/FluidPressure", "std_msgs/msg/Float64"
THRUSTERS = {
    "/auv/thrusters/left/input": (FLOAT, lambda row: {"data": LEFT[row]}),
    "/auv/thrusters/right/input": (FLOAT, lambda row: {"data": RIGHT[row]}),
}


def test_a_bag_of_standard_messages(tmp_path: Path, converted: Converted) -> None:
    """Odometry, Imu, FluidPressure and thrusters as single numbers: everything arrives, the robot by its namespace."""
    topics = {
        "/auv/odom": (ODOMETRY, odometry),
        "/auv/imu/data": ("sensor_msgs/msg/Imu", imu),
        "/auv/pressure": (FLUID, pressure),
    }
    write_bag(tmp_path / "bag", {**topics, **THRUSTERS})
    recording, _ = converted(tmp_path / "bag")
    assert_circle(recording, "auv")
    assert column(recording, "auv", "ground_velocity", "u") == pytest.approx(SPEED)
    assert column(recording, "auv", "imu", "angular_rate_z") == pytest.approx(TURNING)
    assert column(recording, "auv", "pressure", "pressure") == pytest.approx(SEA)
    commands = recording.readings["auv"]["thruster_command"]
    assert set(commands.columns) == {"left", "right"}
    assert commands.column("left")[-1] == pytest.approx(LEFT[-1])


def test_z_down_is_found_by_the_pressure(tmp_path: Path, converted: Converted) -> None:
    """Odometry in north-east-down, which no type tells: z grows with the pressure, which is said."""
    write_bag(tmp_path / "bag", {"/auv/odom": (ODOMETRY, odometry_down), "/auv/pressure": (FLUID, pressure)})
    recording, doubts = converted(tmp_path / "bag")
    assert_circle(recording, "auv")
    assert column(recording, "auv", "ground_velocity", "w") == pytest.approx(-SINKING)
    assert any("z of the pose grows with the depth" in sentence for sentence in doubts)
    assert any("No command of a thruster" in sentence for sentence in doubts)


def test_transforms_alone(tmp_path: Path, converted: Converted) -> None:
    """A bag with /tf and nothing else: the frame that moves in the world is the vehicle."""

    def transform(row: int) -> dict[str, Any]:
        at = 10**9 + row * 10**8
        head = {"stamp": {"sec": at // 10**9, "nanosec": at % 10**9}, "frame_id": "odom"}
        turn = {"translation": vector(X[row], Y[row], -DEPTH[row]), "rotation": heading(YAW[row])}
        kind = "geometry_msgs/msg/TransformStamped"
        tree = {"header": head, "child_frame_id": "base_link", "transform": turn}
        return {"transforms": [type_store.build(kind, tree)]}

    write_bag(tmp_path / "bag", {"/tf": ("tf2_msgs/msg/TFMessage", transform)})
    recording, _ = converted(tmp_path / "bag")
    assert_circle(recording, "vehicle")


def write_csv(file: Path, columns: dict[str, Any], separator: str = ",") -> None:
    """A CSV file with a header."""
    rows = [separator.join(columns)]
    rows += [separator.join(repr(float(cell)) for cell in row) for row in zip(*columns.values(), strict=True)]
    file.write_text("\n".join(rows) + "\n", "utf-8")


def test_columns_with_units(tmp_path: Path, converted: Converted) -> None:
    """Names that say units, and pulses for the thrusters."""
    columns = {
        "time [ms]": 1000.0 * TIME,
        "pos_x_cm": 100.0 * X,
        "pos_y_cm": 100.0 * Y,
        "depth (m)": DEPTH,
        "yaw_deg": np.degrees(YAW),
        "gyro_z_deg_s": np.full(COUNT, math.degrees(TURNING)),
        "pwm_left": 1500.0 + 400.0 * LEFT,
        "pwm_right": 1500.0 + 400.0 * RIGHT,
        "pwm_spare": np.full(COUNT, 1500.0),
    }
    write_csv(tmp_path / "log.csv", columns, ";")
    recording, doubts = converted(tmp_path / "log.csv")
    assert_circle(recording, "vehicle")
    assert column(recording, "vehicle", "imu", "angular_rate_z") == pytest.approx(TURNING)
    assert column(recording, "vehicle", "thruster_command", "left") == pytest.approx(LEFT)
    assert any("'pwm_spare': the same all the time" in sentence for sentence in doubts)
    assert any("servo pulses" in sentence for sentence in doubts)


def test_what_the_motion_tells(tmp_path: Path, converted: Converted) -> None:
    """Without units: a compass bearing in degrees, a velocity in mm/s, a yaw rate in deg/s that is below 10 deg/s."""
    columns = {
        "t": 1e6 * TIME,
        "x": X,
        "y": Y,
        "depth": DEPTH,
        "heading": np.degrees(math.pi / 2 - YAW) % 360.0,
        "vx": np.full(COUNT, 1000.0 * SPEED),
        "vy": np.zeros(COUNT),
        "yaw_rate": np.full(COUNT, math.degrees(TURNING)) * (1.0 + 0.5 * np.sin(TIME)),
    }
    turning = TURNING * (TIME + 0.5 * (1.0 - np.cos(TIME)))  # the integral of that yaw rate
    columns["heading"] = np.degrees(math.pi / 2 - (turning + math.pi / 2)) % 360.0
    columns["x"], columns["y"] = path_along(turning + math.pi / 2)
    write_csv(tmp_path / "log.csv", columns)
    recording, doubts = converted(tmp_path / "log.csv")
    track = recording.tracks["vehicle"]
    assert np.exp(1j * track.yaw) == pytest.approx(np.exp(1j * (turning + math.pi / 2)), abs=1e-3)
    assert column(recording, "vehicle", "velocity", "u") == pytest.approx(SPEED)
    expected = TURNING * (1.0 + 0.5 * np.sin(TIME))
    assert column(recording, "vehicle", "imu", "angular_rate_z") == pytest.approx(expected)
    assert track.stamp_ns[-1] - track.stamp_ns[0] == pytest.approx(TIME[-1] * 1e9)
    assert any("counts clockwise" in sentence for sentence in doubts)
    assert any("rename 'velocity' to 'ground_velocity'" in sentence for sentence in doubts)


def test_a_heading_of_which_the_motion_tells_nothing(tmp_path: Path, converted: Converted) -> None:
    """A vehicle that drifts straight on while it turns: which way its heading counts is in doubt, and that is said."""
    columns = {"t": TIME, "x": SPEED * TIME, "y": 0.0 * TIME, "depth": DEPTH, "heading": np.degrees(YAW) % 360.0}
    write_csv(tmp_path / "log.csv", columns | {"left": LEFT, "right": LEFT})
    _, doubts = converted(tmp_path / "log.csv")
    assert any("which way 'heading' counts" in sentence for sentence in doubts)


def path_along(course: Any) -> tuple[Any, Any]:
    """Places of a vehicle that goes at SPEED along a course (n,) [rad], by the trapezoidal rule."""
    places = []
    for component in (np.cos(course), np.sin(course)):
        steps = 0.5 * TICK * SPEED * (component[1:] + component[:-1])
        places.append(np.append(0.0, np.cumsum(steps)))
    return places[0], places[1]


def ulog(file: Path) -> None:
    """The circle as PX4 logs it, north-east-down, byte by byte as the format's description has it."""

    def message(kind: str, content: bytes) -> bytes:
        return struct.pack("<HB", len(content), ord(kind)) + content

    fields = b"vehicle_local_position:uint64_t timestamp;float x;float y;float z;float heading;"
    parts = [b"ULog\x01\x12\x35\x01" + struct.pack("<Q", 0), message("B", bytes(40)), message("F", fields)]
    parts += [message("F", b"actuator_motors:uint64_t timestamp;float[2] control;")]
    parts += [message("A", struct.pack("<BH", 0, number) + name) for number, name in
              ((1, b"vehicle_local_position"), (2, b"actuator_motors"))]  # fmt: skip
    for row in range(COUNT):
        at = 10**6 + 10**5 * row
        place = (Y[row], X[row], DEPTH[row], math.pi / 2 - YAW[row])
        parts.append(message("D", struct.pack("<HQ4f", 1, at, *place)))
        parts.append(message("D", struct.pack("<HQ2f", 2, at, LEFT[row], RIGHT[row])))
    file.write_bytes(b"".join(parts))


def test_a_ulog(tmp_path: Path, converted: Converted) -> None:
    """PX4's own topics in its own axes."""
    ulog(tmp_path / "log.ulg")
    recording, _ = converted(tmp_path / "log.ulg")
    assert_circle(recording, "vehicle")
    assert len(recording.readings["vehicle"]["thruster_command"].columns) == 2


def test_what_is_no_log(tmp_path: Path) -> None:
    """No map has said anything; the file's name has, or nothing."""
    for name, head, words in (
        ("log.npz", b"just words\n", r"log\.npz is not an npz file, as its name says, and its kind is not known"),
        ("log.npz", b"PK\3\4" + bytes(300), r"log\.npz is damaged or ends early"),
        (
            "log.csv",
            b"PK\3\4".ljust(30) + b"xl/workbook.xml",
            r"not a CSV file, as its name says: it is an Excel file; save",
        ),
        (
            "log.xlsx",
            b"PK\3\4".ljust(30) + b"xl/workbook.xml",
            r"no log that a map.*: it is an Excel file; save it as CSV",
        ),
        (
            "notes.md",
            b"# A page",
            r"no log that a map can be guessed for: its kind is not known; a table has an ending",
        ),
    ):
        (tmp_path / name).write_bytes(head)
        with pytest.raises(CocorosimError, match=words):
            guess(tmp_path / name, tmp_path / "map.yaml")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1,2,3\n4,5,6\n", "has no header"),
        ("t,foo,bar\n0,1,2\n1,2,3\n2,3,4\n", "Nothing in"),
        ("a,b\n1,1\n1,1\n", "no column that rises"),
    ],
)
def test_what_is_not_recognised(tmp_path: Path, text: str, words: str) -> None:
    """A sentence, and no map."""
    (tmp_path / "log.csv").write_text(text, "utf-8")
    with pytest.raises(CocorosimError, match=words):
        guess(tmp_path / "log.csv", tmp_path / "map.yaml")
    assert not (tmp_path / "map.yaml").exists()


@pytest.mark.parametrize(
    ("names", "pattern"),
    [
        (["run1_imu.csv", "run2_imu.csv"], "run{run}_imu.csv"),
        (["a_imu.csv", "b_imu.csv", "ab_imu.csv"], "{run}_imu.csv"),
        (["dive.csv", "dive2.csv"], "dive{run}.csv"),
        (["01.csv", "11.csv"], "{run}1.csv"),
        (["day_3_imu.csv"], "{run}.csv"),
    ],
)
def test_what_the_files_of_a_table_share_stays_in_its_pattern(names: list[str], pattern: str) -> None:
    """Beginning and end; what stands between is the run, of at least one character where the others have one."""
    assert _pattern([Path(name) for name in names]) == pattern


def test_a_folder_of_several_tables_for_each_run(tmp_path: Path, converted: Converted) -> None:
    """Poses and commands in files of their own, of two runs: the map that is guessed makes a recording of each run."""
    (tmp_path / "log").mkdir()
    for run in (1, 2):
        poses = {"time_s": TIME, "pos_x_m": X, "pos_y_m": Y, "depth_m": DEPTH, "yaw_rad": YAW}
        write_csv(tmp_path / "log" / f"run{run}_camera.csv", poses)
        pulses = {"time_s": TIME, "pwm_left": 1500.0 + 400.0 * LEFT, "pwm_right": 1500.0 + 400.0 * RIGHT}
        write_csv(tmp_path / "log" / f"run{run}_motors.csv", pulses)
    recording, _ = converted(tmp_path / "log")
    assert_circle(recording, "vehicle")
    assert column(recording, "vehicle", "thruster_command", "left") == pytest.approx(LEFT)
    assert len(list((tmp_path / "out").iterdir())) == 2
