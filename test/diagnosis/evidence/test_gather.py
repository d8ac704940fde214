"""Recordings become streams on one clock, in order, each moment once; what was done is said."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.cleaning import is_noteworthy, timing_sentence
from cocorosim_ros.diagnosis.evidence.frames.needed_corrections import needed_corrections
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence, gather_recording
from cocorosim_ros.diagnosis.evidence.intake import take_in
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.type_store import build, serialize

POSE, COMPASS, COMMAND = "/lily_01/pose", "/lily_01/compass", "/lily_01/thruster_command"
Record = Callable[..., Path]


def test_streams_of_a_clean_recording(record: Record, circle: Any, lily_platform: Platform) -> None:
    """Values and stamps come back, time counts from the first message, angles go on counting, noise is estimated."""
    recording = gather_recording(record(circle), lily_platform)
    (robot,) = recording.robots
    assert robot.name == "lily_01"
    assert recording.duration == pytest.approx(39.9)
    pose, compass = robot.streams["pose"], robot.streams["compass"]
    np.testing.assert_allclose(pose.time, circle[POSE].stamp, atol=1e-8)
    np.testing.assert_array_equal(pose.value[:, :3], circle[POSE].numbers[:, :3])
    np.testing.assert_allclose(pose.value[:, 3], 0.1 * circle[POSE].stamp, atol=1e-9)
    np.testing.assert_allclose(compass.value[:, 0], 0.1 * compass.time, atol=0.1)
    np.testing.assert_allclose(pose.noise[:3], 0.002, rtol=0.25)
    assert compass.noise[0] == pytest.approx(0.02, rel=0.25)
    np.testing.assert_allclose(robot.command_time, circle[COMMAND].stamp, atol=1e-8)
    np.testing.assert_array_equal(robot.command, circle[COMMAND].numbers)
    assert robot.gaps == ()


def beside(circle: Any) -> Any:
    """The same run a hand's breadth further, so that it is another recording."""
    return circle | {POSE: circle[POSE].changed(numbers=circle[POSE].numbers + np.eye(5)[0] * 0.1)}


def test_several_bags(record: Record, circle: Any, lily_platform: Platform) -> None:
    """One recording per bag, in the order given."""
    evidence = gather_evidence([record(circle, "a"), record(beside(circle), "b")], lily_platform)
    assert [Path(recording.origin).name for recording in evidence.recordings] == ["a", "b"]
    assert evidence.platform is lily_platform


def test_a_recording_counts_once(record: Record, circle: Any, lily_platform: Platform) -> None:
    """Given twice, or as a copy under another name, it would be evidence twice."""
    first, copy = record(circle, "first"), record(circle, "copy")
    for twice in ([first, first], [first, record(beside(circle), "other"), copy]):
        with pytest.raises(
            CocorosimError, match=r"says the same as .*first, reading by reading; give every recording once"
        ):
            gather_evidence(twice, lily_platform)


def test_order_and_duplicates(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """Late messages are sorted in, double ones count once, contradictory ones as the first says."""
    pose = circle[POSE]
    log = pose.stamp.copy()
    log[50] += 0.35
    twice = np.sort(np.append(np.arange(pose.stamp.size), [7, 7, 9]))
    numbers = pose.numbers[twice].copy()
    numbers[np.flatnonzero(twice == 9)[1], 0] += 1.0
    circle[POSE] = pose.changed(stamp=pose.stamp[twice], log=log[twice], numbers=numbers)
    recording = gather_recording(record(circle), lily_platform)
    stream = recording.robots[0].streams["pose"]
    np.testing.assert_allclose(stream.time, pose.stamp, atol=1e-8)
    np.testing.assert_array_equal(stream.value[:, 0], pose.numbers[:, 0])
    assert is_said(recording.remarks, "lily_01/pose", "backwards at 1 place", "by up to 0.3 s", "sorted")
    assert is_said(recording.remarks, "lily_01/pose", "2 messages were recorded twice")
    assert is_said(recording.remarks, "lily_01/pose", "1 message has the stamp of another one")


def test_what_is_no_number_is_left_out(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """A pose without place is none, even with an attitude; the other streams do not mind."""
    numbers = circle[POSE].numbers.copy()
    numbers[10:15, 1] = np.nan
    heading = circle[COMPASS].numbers.copy()
    heading[3] = math.inf
    circle |= {POSE: circle[POSE].changed(numbers=numbers), COMPASS: circle[COMPASS].changed(numbers=heading)}
    recording = gather_recording(record(circle), lily_platform)
    streams = recording.robots[0].streams
    assert len(streams["pose"].time) == 395 and np.isfinite(streams["pose"].value).all()
    assert len(streams["compass"].time) == 399
    assert is_said(recording.remarks, "lily_01/pose", "5 of 400", "first 1.0 s")
    assert is_said(recording.remarks, "lily_01/compass", "1 of 400")


def test_a_camera_without_heading(record: Record, circle: Any, lily_platform: Platform) -> None:
    """Zero quaternions: the places stay, the yaw is not given."""
    numbers = circle[POSE].numbers.copy()
    numbers[:, 3:] = 0.0
    circle[POSE] = circle[POSE].changed(numbers=numbers)
    stream = gather_recording(record(circle), lily_platform).robots[0].streams["pose"]
    assert len(stream.time) == 400 and np.isnan(stream.value[:, 3]).all() and np.isnan(stream.noise[3])


def test_any_subset_of_topics(record: Record, circle: Any, topic: Any, lily_platform: Platform) -> None:
    """Depth and yaw rate only; an IMU that does not measure acceleration says so by REP 145 or by zeros."""
    time = circle[POSE].stamp
    rate = np.column_stack([np.full(time.size, 0.1), *np.zeros((3, time.size))])
    unknown = {"linear_acceleration_covariance": np.array([-1.0, *np.zeros(8)])}
    topics = {
        COMMAND: circle[COMMAND],
        "/lily_01/pressure": topic(time, np.full((time.size, 1), 107000.0)),
        "/lily_01/imu": topic(time, rate + np.array([0.0, 1.0, 1.0, 1.0]), extra=unknown),
        "/lily_02/imu": topic(time, rate),
        "/lily_02/velocity": topic(time, np.ones((time.size, 3))),
    }
    first, second = gather_recording(record(topics), lily_platform).robots
    assert sorted(first.streams) == ["imu", "pressure"] and sorted(second.streams) == ["imu", "velocity"]
    for robot in (first, second):
        np.testing.assert_allclose(robot.streams["imu"].value[:, 0], 0.1)
        assert np.isnan(robot.streams["imu"].value[:, 1:]).all()
    assert first.streams["pressure"].value[0] == 107000.0
    assert second.command.shape == (0, 3) and second.command_time.size == 0


def test_an_imu_without_rate(record: Record, circle: Any, topic: Any, lily_platform: Platform) -> None:
    """The rate is not given where its covariance says -1."""
    time = circle[POSE].stamp
    readings = np.column_stack([np.zeros((time.size, 3)), np.full(time.size, 9.81)])
    extra = {"angular_velocity_covariance": np.array([-1.0, *np.zeros(8)])}
    circle["/lily_01/imu"] = topic(time, readings, extra=extra)
    stream = gather_recording(record(circle), lily_platform).robots[0].streams["imu"]
    assert np.isnan(stream.value[:, 0]).all()
    np.testing.assert_allclose(stream.value[:, 1:], readings[:, 1:])


def test_accelerations_in_steps_that_hide_the_motion(
    record: Record, circle: Any, topic: Any, lily_platform: Platform, is_said: Any
) -> None:
    """They are left out and said to be; the rate beside them stays, and so do accelerations in finer steps."""
    time = circle[POSE].stamp
    felt = 0.02 * np.random.default_rng(3).standard_normal((time.size, 3))
    readings = np.column_stack(
        [np.full(time.size, 0.1), np.rint(felt / [0.1, 0.1, 0.01]) * [0.1, 0.1, 0.01] + [0.0, 0.0, 9.8]]
    )
    circle["/lily_01/imu"] = topic(time, readings)
    recording = gather_recording(record(circle), lily_platform)
    value = recording.robots[0].streams["imu"].value
    assert np.isnan(value[:, 1:3]).all() and np.isfinite(value[:, [0, 3]]).all()
    assert is_said(recording.remarks, "accel_x, accel_y hardly leave one step of the instrument's digits")


def test_an_imu_that_tells_the_attitude_alone(record: Record, circle: Any, topic: Any, lily_platform: Platform) -> None:
    """Its pitch is known; without rates and forces it is no stream of readings, and nothing that follows meets one."""
    time = circle[POSE].stamp
    unknown = np.array([-1.0, *np.zeros(8)])
    extra = {f"{name}_covariance": unknown for name in ("angular_velocity", "linear_acceleration")}
    extra |= {"orientation": build("geometry_msgs/msg/Quaternion", {"y": math.sin(0.15), "w": math.cos(0.15)})}
    circle["/lily_01/imu"] = topic(time, np.zeros((time.size, 4)), extra=extra)
    evidence = gather_evidence([record(circle)], lily_platform)
    robot = evidence.recordings[0].robots[0]
    assert "imu" not in robot.streams
    assert robot.attitude is not None
    np.testing.assert_allclose(robot.attitude.pitch, 0.3)
    assert take_in(evidence).reasons == ()


def test_faulty_readings_are_left_out(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """A compass that once says nonsense loses that reading, a pose only the wrong yaw; the noise stays."""
    heading, numbers = circle[COMPASS].numbers.copy(), circle[POSE].numbers.copy()
    heading[50] += 1.5
    numbers[60, 3:] = np.sin(-1.0), np.cos(-1.0)
    circle |= {COMPASS: circle[COMPASS].changed(numbers=heading), POSE: circle[POSE].changed(numbers=numbers)}
    yaw = circle[POSE].stamp * 0.1 + 0.02 * np.random.default_rng(4).standard_normal(400)
    circle[POSE].numbers[:, 3:] = np.where(
        np.arange(400)[:, None] == 60, numbers[:, 3:], np.column_stack([np.sin(yaw / 2), np.cos(yaw / 2)])
    )
    recording = gather_recording(record(circle), lily_platform)
    compass, pose = recording.robots[0].streams["compass"], recording.robots[0].streams["pose"]
    assert len(compass.time) == 399 and not np.any(np.isclose(compass.time, 5.0))
    assert np.flatnonzero(np.isnan(pose.value[:, 3])).tolist() == [60] and np.isfinite(pose.value[:, :3]).all()
    assert compass.noise[0] == pytest.approx(0.02, rel=0.25)
    assert is_said(recording.remarks, "lily_01/compass: 1 single readings of heading", "first at 5.0 s")
    assert is_said(recording.remarks, "lily_01/pose: 1 single readings of yaw", "first at 6.0 s")


def test_robots_that_a_camera_confuses(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """Two robots exchanged from 20 s on are exchanged back, and it is said which and when."""
    pose = circle[POSE]
    aside = pose.numbers + np.array([1.0, 0.0, 0.0, 0.0, 0.0])
    late = (pose.stamp >= 20.0)[:, None]
    circle |= {
        POSE: pose.changed(numbers=np.where(late, aside, pose.numbers)),
        "/lily_02/pose": pose.changed(numbers=np.where(late, pose.numbers, aside)),
    }
    recording = gather_recording(record(circle), lily_platform)
    first, second = (robot.streams["pose"].value for robot in recording.robots)
    np.testing.assert_array_equal(first[:, :3], pose.numbers[:, :3])
    np.testing.assert_array_equal(second[:, :3], aside[:, :3])
    assert is_said(recording.remarks, "lily_01/pose and lily_02/pose", "at 20.0 s", "exchanged back")


def test_gaps_of_the_poses(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """From when to when the camera saw nothing for long."""
    pose = circle[POSE]
    keep = ((pose.stamp < 9.95) | (pose.stamp > 13.05)) & ((pose.stamp < 20.05) | (pose.stamp > 20.45))
    circle[POSE] = pose.changed(stamp=pose.stamp[keep], numbers=pose.numbers[keep])
    recording = gather_recording(record(circle), lily_platform)
    np.testing.assert_allclose(recording.robots[0].gaps, [(9.9, 13.1)], atol=1e-8)
    assert is_said(recording.remarks, "lily_01/pose", "10 Hz", "1 gap from 9.9 to 13.1 s")


def test_jitter_is_said(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """Uneven intervals are said, even ones are not."""
    stamps = np.sort(circle[COMPASS].stamp + np.random.default_rng(0).uniform(0.0, 0.09, 400))
    circle[COMPASS] = circle[COMPASS].changed(stamp=stamps)
    remarks = gather_recording(record(circle), lily_platform).remarks
    assert is_said(remarks, "lily_01/compass", "unevenly (jitter")
    assert not is_said(remarks, "lily_01/pose", "unevenly")


@pytest.mark.parametrize(("writers", "apart", "period"), [(4, 1e-5, 0.1), (4, 1e-3, 5.0), (2, 1e-3, 0.1)])
def test_bunches_have_a_mean_rate(writers: int, apart: float, period: float) -> None:
    """Writers of one topic that write shortly after each other do not write at the rate of the time between them."""
    together = (period * np.arange(50)[:, None] + apart * np.arange(writers)).ravel()
    said = timing_sentence("commands", np.delete(together, 30))
    assert said == f"commands: {50 * writers - 1} readings in bunches, {(writers - 0.02) / period:.3g} a second."
    assert not is_noteworthy(said)
    paused = timing_sentence("commands", np.append(together, together + 100.0 * period))
    last, again = 49 * period, 100 * period
    assert paused.endswith(f"{writers / period:.3g} a second, 1 gap from {last:.1f} to {again:.1f} s.")
    assert is_noteworthy(paused)


def test_a_long_gap_makes_no_bunches() -> None:
    """Two minutes of even readings an hour apart are even readings."""
    even = 0.1 * np.arange(1200)
    said = timing_sentence("pose", np.append(even, even + 3600.0))
    assert said == "pose: 2400 readings at 10 Hz, 1 gap from 119.9 to 3600.0 s."


def test_heading_over_a_gap_follows_the_gyroscope(
    record: Record, circle: Any, topic: Any, poses: Any, lily_platform: Platform
) -> None:
    """Where no pose is seen for 8 s at 1.2 rad/s, the gyroscope counts the turns, if it goes on."""
    time = np.arange(0.0, 100.0, 0.1)
    yaw = np.where(time < 50.0, 1.2 * time, 60.0 - 0.4 * (time - 50.0))
    keep = (time < 30.0) | (time > 38.0)
    circle[POSE] = topic(time[keep], poses(time[keep] * 0.01, 0.0, 0.0, yaw[keep]))
    del circle[COMPASS]
    alone = gather_recording(record(circle, "alone"), lily_platform).robots[0].streams["pose"]
    assert alone.value[-1, 3] == pytest.approx(yaw[-1] - 2 * np.pi * round(1.2 * 8.1 / (2 * np.pi)), abs=1e-6)
    rate = np.where(time < 50.0, 1.2, -0.4) + 0.01
    circle["/lily_01/imu"] = topic(time, np.column_stack([rate, *np.zeros((3, time.size))]))
    helped = gather_recording(record(circle, "helped"), lily_platform).robots[0].streams["pose"]
    np.testing.assert_allclose(helped.value[:, 3], yaw[keep], atol=1e-6)
    both = (time < 31.0) | (time > 37.0)
    imu = circle["/lily_01/imu"]
    circle["/lily_01/imu"] = imu.changed(stamp=time[both], numbers=imu.numbers[both])
    blind = gather_recording(record(circle, "blind"), lily_platform).robots[0].streams["pose"]
    np.testing.assert_allclose(blind.value[:, 3], alone.value[:, 3], atol=1e-6)


def test_headings_in_degrees_go_on_counting(record: Record, circle: Any, topic: Any, lily_platform: Platform) -> None:
    """Readings beyond any angle in radians turn over at 360."""
    time = np.arange(0.0, 100.0, 0.1)
    circle[COMPASS] = topic(time, (17.0 * time % 360.0)[:, None])
    stream = gather_recording(record(circle), lily_platform).robots[0].streams["compass"]
    np.testing.assert_allclose(stream.value[:, 0], 17.0 * time, atol=1e-9)


def test_commands_that_are_not_usable(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """NaN is off, more than all is all, silent actuators are off; all of it is said."""
    command = circle[COMMAND]
    numbers = command.numbers.copy()
    numbers[5, 1], numbers[6, 0] = np.nan, 3.0
    circle[COMMAND] = command.changed(numbers=numbers[:, :2], names=("right", "left"))
    recording = gather_recording(record(circle), lily_platform)
    found = recording.robots[0].command
    np.testing.assert_array_equal(found[:5], numbers[:5, [1, 0, 0]] * [1, 1, 0])
    assert found[5].tolist() == [0.0, numbers[5, 0], 0.0]
    assert found[6].tolist() == [numbers[6, 1], 1.0, 0.0]
    assert is_said(recording.remarks, "1 message has a command that is no number")
    assert is_said(recording.remarks, "1 message commands more than the maximum (up to 3")
    assert is_said(recording.remarks, "buoyancy is never commanded")


def test_an_actuator_beside_those_of_the_platform(
    record: Record, circle: Any, lily_platform: Platform, is_said: Any
) -> None:
    """What the model does not have is not used, and said."""
    command = circle[COMMAND]
    numbers = np.column_stack([command.numbers, np.ones(len(command.numbers))])
    circle[COMMAND] = command.changed(numbers=numbers, names=("left", "right", "buoyancy", "lamp"))
    recording = gather_recording(record(circle), lily_platform)
    assert is_said(recording.remarks, "no actuator lamp")
    assert recording.robots[0].commanded == ("left", "right", "buoyancy", "lamp")
    np.testing.assert_array_equal(recording.robots[0].command, command.numbers)


def test_an_actuator_by_another_name(record: Record, circle: Any, lily_platform: Platform) -> None:
    """Its commands would be missing from the model: nothing is diagnosed before the names agree."""
    circle[COMMAND] = circle[COMMAND].changed(names=("left", "rigth", "buoyancy"))
    with pytest.raises(
        CocorosimError, match=r"commands rigth, which the platform does not have, and never right.*rename"
    ):
        gather_recording(record(circle), lily_platform)


def test_actuators_of_another_platform(record: Record, circle: Any, lily_platform: Platform) -> None:
    """If no name fits, the sentence says which occur and which the platform has."""
    circle[COMMAND] = circle[COMMAND].changed(names=("m1", "m2", "m3"))
    with pytest.raises(CocorosimError, match=r"bag: /lily_01/thruster_command .* m1, m2, m3, .* left, right, buoyancy"):
        gather_recording(record(circle), lily_platform)


def test_a_robot_of_another_kind_is_left_out(
    record: Record, circle: Any, lily_platform: Platform, is_said: Any
) -> None:
    """Where others fit, a robot whose commands name none of the actuators is left out, with all its topics."""
    circle |= {
        "/jeff/pose": circle[POSE],
        "/jeff/thruster_command": circle[COMMAND].changed(names=("m1", "m2", "m3")),
    }
    recording = gather_recording(record(circle), lily_platform)
    assert [robot.name for robot in recording.robots] == ["lily_01"]
    assert is_said(recording.remarks, "jeff was left out", "m1")


def test_no_topic_of_a_robot(record: Record, circle: Any, lily_platform: Platform) -> None:
    """The sentence names the topics that there are."""
    with pytest.raises(CocorosimError, match=r"/lily_01/illuminance.*cocorosim convert"):
        gather_recording(_bag_of_light(record, circle), lily_platform)


def _bag_of_light(record: Record, circle: Any) -> Path:
    extra = {"illuminance": 3.0}
    light = circle[POSE].changed(numbers=np.zeros((400, 0)), extra=extra)
    return record({"/lily_01/illuminance": light})


def test_a_topic_of_another_type_is_said(tmp_path: Path, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """A velocity without stamps is not used, and the remark says what it should be."""
    twist = "geometry_msgs/msg/Twist"
    pose = "geometry_msgs/msg/PoseStamped"
    with BagWriter(tmp_path / "bag", [Channel("/a/velocity", twist), Channel("/a/pose", pose)]) as bag:
        bag.write("/a/velocity", 1, 1, serialize(build(twist)))
        bag.write("/a/pose", 1, 1, serialize(build(pose)))
        bag.write("/a/pose", 2, 2, b"\x00\x01\x00\x00rubbish")
    recording = gather_recording(tmp_path / "bag", lily_platform)
    assert sorted(recording.robots[0].streams) == ["pose"]
    assert is_said(recording.remarks, "/a/velocity", twist, "geometry_msgs/msg/TwistStamped")
    assert is_said(recording.remarks, "/a/pose", "1 of 2 messages could not be read")


@pytest.mark.parametrize("count", [1, 2, 3, 8, 35])
def test_recordings_of_a_few_messages(
    record: Record, circle: Any, topic: Any, lily_platform: Platform, count: int
) -> None:
    """Nothing breaks and nothing warns; there is a reason to abstain."""
    time = circle[POSE].stamp[:count]
    topics = {name: each.changed(stamp=time, numbers=each.numbers[:count]) for name, each in circle.items()}
    topics |= {
        "/lily_01/pressure": topic(time, np.full((count, 1), 1e5)),
        "/lily_01/imu": topic(time, np.ones((count, 4))),
        "/lily_01/velocity": topic(time, np.ones((count, 3))),
        "/lily_02/pose": topics[POSE],
    }
    evidence = gather_evidence([record(topics)], lily_platform)
    assert len(take_in(evidence).reasons) == 2
    needed_corrections(evidence.recordings[0].robots[0], lily_platform)


def test_a_truncated_file(record: Record, circle: Any, lily_platform: Platform, is_said: Any) -> None:
    """What is left of a recording that was cut off is used, and it is said how far it goes."""
    path = record(circle)
    whole = read_bag(path)
    cut = path.parent / "cut"
    channels = [Channel(entry.topic, entry.type_name) for entry in whole.summary.topics]
    with BagWriter(cut, channels, chunk_bytes=4096) as bag:
        for message in whole.messages():
            bag.write(*message[:1], *message[2:])
    (file,) = cut.glob("*.mcap")
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    recording = gather_recording(file, lily_platform)
    assert 5.0 < recording.duration < 35.0
    assert is_said(recording.remarks, "was not closed", str(file))


def test_remarks_of_several_recordings(record: Record, circle: Any, lily_platform: Platform) -> None:
    """Each names its recording, once; those of a single recording need not."""
    first, second = record(circle, "first"), record(beside(circle), "second")
    (alone,) = gather_evidence([first], lily_platform).recordings
    assert alone.remarks and not any(str(first) in remark for remark in alone.remarks)
    intake = take_in(gather_evidence([first, second], lily_platform))
    for path, recording in zip((first, second), intake.evidence.recordings, strict=True):
        assert recording.remarks == tuple(f"{path}: {remark}" for remark in alone.remarks)


def test_a_file_cut_off_before_its_first_reading(record: Record, circle: Any, lily_platform: Platform) -> None:
    """The sentence says that it was cut off, not that it wants converting."""
    (file,) = record(circle).glob("*.mcap")
    file.write_bytes(file.read_bytes()[:200])
    with pytest.raises(CocorosimError, match=r"no reading and no command .* was not closed.*[^.]; record again"):
        gather_recording(file, lily_platform)


def test_time_of_reading(record: Record, circle: Any, topic: Any, lily_platform: Platform) -> None:
    """Ten minutes of three robots, 50 Hz IMU: some 150 000 messages in at most 5 s of a busy machine (1 s idle)."""
    kinds = {"pose": ("geometry_msgs/msg/PoseStamped", 10), "imu": ("sensor_msgs/msg/Imu", 50)}
    kinds |= {"compass": ("cocorosim_msgs/msg/Compass", 10), "pressure": ("sensor_msgs/msg/FluidPressure", 10)}
    path = record(circle, "unused").parent / "long"
    names = [f"/lily_{robot}/{kind}" for robot in range(3) for kind in kinds]
    with BagWriter(path, [Channel(name, kinds[name.split("/")[2]][0]) for name in names]) as bag:
        for name in names:
            type_name, rate = kinds[name.split("/")[2]]
            packed = PackedMessage([build(type_name)], [])
            for stamp in range(0, 600 * 10**9, 10**9 // rate):
                bag.write(name, stamp, stamp, packed.encode(stamp)[0])
    start = clock.process_time()
    recording = gather_recording(path, lily_platform)
    assert clock.process_time() - start < 5.0
    assert sum(len(stream.time) for robot in recording.robots for stream in robot.streams.values()) == 144_000
