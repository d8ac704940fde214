"""Attitudes: those of the body alone, those that are none, and those that another topic knows."""

from __future__ import annotations

import math
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

Convert = Callable[..., SimpleNamespace]
QUATERNION = ", ".join(f"q{axis}: {{column: q{axis}}}" for axis in "xyzw")
POSE = f"pose: {{x: {{fixed: 0 m}}, y: {{fixed: 0 m}}, z: {{fixed: 0 m}}, {QUATERNION}}}"


def table(streams: str) -> str:
    """One table of a map."""
    return f"  - {{files: a.csv, robot: boat, time: {{column: t, unit: s}}, streams: {{{streams}}}}}\n"


def log(*rows: tuple[float, ...]) -> dict[str, str]:
    """A file of quaternions x y z w, one a second."""
    return {"a.csv": "t,qx,qy,qz,qw\n" + "".join(f"{t},{','.join(map(str, row))}\n" for t, row in enumerate(rows))}


@pytest.mark.parametrize("streams", [POSE, f"imu: {{{QUATERNION}}}"])
def test_not_normalised(convert_csv: Convert, streams: str) -> None:
    """The first such row, its norm and how many more are named."""
    sentence = r"not normalised in a.csv line 3 and 1 more \(norm 2\); check which columns qx, qy, qz and qw are"
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(table(streams), log((0, 0, 0, 1), (0, 0, 0, 2), (30, 0, 10, 45)))


def test_rounded_and_unset(convert_csv: Convert) -> None:
    """Three decimals are near enough; four zeros mean that nothing was known, and the row is left out and counted."""
    result = convert_csv(table(POSE), log((0, 0, 0, 0), (0.5, 0.5, 0.5, 0.5), (0.577, 0.577, 0.577, 0)))
    assert [message.at // 10**9 for message in result.topics["/boat/pose"]] == [1, 2]
    assert "1 row with an attitude of four zeros, which was not known, was left out" in result.findings[0]


def test_an_attitude_that_was_never_known(convert_csv: Convert) -> None:
    """A pose would be missing from the recording, in silence; of an IMU the rates may do without."""
    with pytest.raises(CocorosimError, match=r"four zeros in all rows of a\.csv.*give 'yaw' instead"):
        convert_csv(table(POSE), log((0, 0, 0, 0), (0, 0, 0, 0)))
    other = f"imu: {{{QUATERNION}}}, compass: {{heading: {{fixed: 0 rad}}}}"
    result = convert_csv(table(other), log((0, 0, 0, 0), (0, 0, 0, 0)))
    assert list(result.topics) == ["/boat/compass"]
    assert "2 rows with an attitude of four zeros, which was not known, were left out" in result.findings[0]


PLACE = "x: {column: x, unit: m}, y: {column: x, unit: m}, z: {fixed: 0 m}"


@pytest.mark.parametrize("axes", ["enu_flu", "ned_frd"])
def test_a_place_without_a_heading(convert_csv: Convert, axes: str) -> None:
    """Poses of a GPS are there, with an attitude of four zeros: it was not recorded, and no direction stands in."""
    streams = f"pose: {{axes: {axes}, {PLACE}, yaw: {{unknown: true}}}}"
    poses = convert_csv(table(streams), {"a.csv": "t,x\n0,1\n1,2\n"}).topics["/boat/pose"]
    assert [message.content.pose.position.x for message in poses] == [1, 2]
    assert all(getattr(message.content.pose.orientation, axis) == 0.0 for message in poses for axis in "xyzw")


@pytest.mark.parametrize(
    ("yaw", "sentence"),
    [
        ("{unknown: false}", "has 'unknown: false'; name a column, a fixed angle, or 'unknown: true'"),
        ("{unknown: true, travel: true}", "travel"),
        ("{unknown: true}, roll: {column: x, unit: deg}", "has 'roll' or 'pitch' beside a 'yaw' that was not recorded"),
    ],
)
def test_an_unknown_heading_stands_alone(convert_csv: Convert, yaw: str, sentence: str) -> None:
    """With nothing beside it that says something of it, or that would be lost."""
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(table(f"pose: {{{PLACE}, yaw: {yaw}}}"), {"a.csv": "t,x\n0,1\n"})


def test_pitch_alone(convert_csv: Convert) -> None:
    """A glider's pitch, without position or heading: an attitude of which the other axes are marked as unknown."""
    result = convert_csv(table("imu: {pitch: {column: p, unit: deg}}"), {"a.csv": "t,p\n1,60\n"})
    imu = result.topics["/boat/imu"][0].content
    quaternion = [imu.orientation.x, imu.orientation.y, imu.orientation.z, imu.orientation.w]
    assert quaternion == pytest.approx([0, 0.5, 0, math.sqrt(0.75)])
    assert list(imu.orientation_covariance) == [1e6, 0, 0, 0, 0, 0, 0, 0, 1e6]
    assert imu.angular_velocity_covariance[0] == imu.linear_acceleration_covariance[0] == -1


def test_pitch_of_marine_axes(convert_csv: Convert) -> None:
    """Forward-right-down: a positive pitch lifts the nose, which is a negative turn about the left axis."""
    streams = "imu: {axes: ned_frd, pitch: {column: p, unit: deg}, roll: {column: p, unit: deg, scale: 0}}"
    imu = convert_csv(table(streams), {"a.csv": "t,p\n1,60\n"}).topics["/boat/imu"][0].content
    x, y, z, w = (getattr(imu.orientation, axis) for axis in "xyzw")
    assert 2 * (x * z - w * y) == pytest.approx(math.sin(math.radians(60)))  # how far the nose points up
    assert list(np.diag(np.reshape(imu.orientation_covariance, (3, 3)))) == [0, 0, 1e6]


@pytest.mark.parametrize("topic", ["pose", "imu"])
def test_half_a_quaternion(convert_csv: Convert, topic: str) -> None:
    """Both topics want all of it."""
    given = "x: {fixed: 0 m}, y: {fixed: 0 m}, z: {fixed: 0 m}, " if topic == "pose" else ""
    with pytest.raises(CocorosimError, match="needs all of 'qx', 'qy', 'qz', 'qw'"):
        convert_csv(table(f"{topic}: {{{given}qx: {{column: qx}}, yaw: {{fixed: 0 deg}}}}"), log((0, 0, 0, 1)))


FOLDER = str(Path(__file__).parents[2] / "contracts")
BESIDE = """\
name: m
format: tlog
tables:
  - topic: {topic}
    time: {{column: time_boot_ms, unit: ms}}
    robot: rov
    beside: {{attitude: {{topic: ATTITUDE, within: 0.4 s}}}}
    streams:
      pose:
        axes: ned_frd
        x: {{column: x, unit: m}}
        y: {{column: y, unit: m}}
        z: {{column: z, unit: m}}
        yaw: {{column: attitude.yaw, unit: rad}}
"""


@pytest.fixture
def tlog(tmp_path: Path) -> Path:
    """Positions at 1, 2, 3 s, yaws at 0.9, 2.1 and 3.5 s; the last one is too far away."""
    if FOLDER not in sys.path:
        sys.path.append(FOLDER)
    from logs_by_format import local_position, mavlink

    def attitude(time_ms: int, yaw: float) -> bytes:
        return mavlink(30, struct.pack("<I6f", time_ms, 0, 0, yaw, 0, 0, 0), 39)

    parts = [local_position(1000 * row, row, 0, 1, 0, 0, 0) for row in (1, 2, 3)]
    parts += [attitude(900, 0.25), attitude(2100, 0.5), attitude(3500, 0.75)]
    file = tmp_path / "log.tlog"
    times = [int.from_bytes(part[6:10], "little") * 1000 for part in parts]
    file.write_bytes(b"".join(struct.pack(">Q", time) + part for time, part in zip(times, parts, strict=True)))
    return file


def test_a_topic_beside(tlog: Path, tmp_path: Path) -> None:
    """Each position takes the nearest yaw; without one near enough it is left out and counted."""
    (tmp_path / "map.yaml").write_text(BESIDE.format(topic="LOCAL_POSITION_NED"))
    made = convert(load_map(tmp_path / "map.yaml"), tlog, tmp_path / "ours")[0].conversion
    (stream,) = made.streams
    yaw = 2 * np.arctan2(stream.rows.values[:, 5], stream.rows.values[:, 6])
    assert np.sin(yaw) == pytest.approx(np.cos([0.25, 0.5]))  # from east to the left, not from north to the right
    assert np.cos(yaw) == pytest.approx(np.sin([0.25, 0.5]))
    assert stream.rows.values[:, 1].tolist() == [1.0, 2.0]
    assert "1 row with missing" in made.findings[0]


def test_no_such_topic_beside(tlog: Path, tmp_path: Path) -> None:
    """What is there is said."""
    text = BESIDE.format(topic="LOCAL_POSITION_NED").replace("topic: ATTITUDE", "topic: ATITUDE")
    (tmp_path / "map.yaml").write_text(text)
    with pytest.raises(CocorosimError, match=r"beside.attitude' names ATITUDE, which has no message in log.tlog; did"):
        convert(load_map(tmp_path / "map.yaml"), tlog, tmp_path / "ours")
