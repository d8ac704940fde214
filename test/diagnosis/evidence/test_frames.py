"""Axes, signs and units that are mixed up are found and put right; clean recordings need none."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.frames.agreement import nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import corrected
from cocorosim_ros.diagnosis.evidence.frames.mirrored_poses import mirrored_poses
from cocorosim_ros.diagnosis.evidence.frames.motion import motion_together
from cocorosim_ros.diagnosis.evidence.frames.needed_corrections import needed_corrections
from cocorosim_ros.diagnosis.evidence.frames.units import height_unit, pressure_unit
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream
from cocorosim_ros.scenario.parts.platform import Platform, load_platform

Swum = Callable[[Any], RobotLog]
DEGREES = 180.0 / np.pi
TOPICS = ("pose", "compass", "pressure", "imu", "velocity")


def mixed(log: RobotLog, topic: str, change: Callable[[np.ndarray], np.ndarray]) -> RobotLog:
    """The log with the values of a topic changed; change works on (columns, n)."""
    if topic == "thruster_command":
        return replace(log, command=np.asarray(change(log.command.T)).T)
    stream = log.streams[topic]
    return replace(log, streams={**log.streams, topic: replace(stream, value=np.asarray(change(stream.value.T)).T)})


def in_world(log: RobotLog) -> RobotLog:
    """The log with its velocity in world axes."""
    stream, pose = log.streams["velocity"], log.streams["pose"]
    yaw = np.interp(stream.time, pose.time, pose.value[:, 3])
    u, v, w = stream.value.T
    turned = np.column_stack([u * np.cos(yaw) - v * np.sin(yaw), u * np.sin(yaw) + v * np.cos(yaw), w])
    return replace(log, streams={**log.streams, "velocity": replace(stream, value=turned)})


# topic, what was done to it (columns first), words of the correction
MIXUPS: list[tuple[str, Callable[..., Any], str]] = [
    ("pose", lambda v: [v[1], v[0], -v[2], np.pi / 2 - v[3]], "north-east-down"),
    ("pose", lambda v: [v[1], v[0], v[2], v[3]], "x and y are swapped"),
    ("pose", lambda v: [-v[0], v[1], v[2], v[3]], "sign of x is flipped"),
    ("pose", lambda v: [v[0], -v[1], v[2], v[3]], "sign of y is flipped"),
    ("pose", lambda v: [v[0], v[1], -v[2], v[3]], "z points down"),
    ("pose", lambda v: [v[0], v[1], v[2], -v[3]], "yaw, its sign is flipped"),
    ("pose", lambda v: [v[0], v[1], v[2], np.pi / 2 - v[3]], "yaw, it counts clockwise from north"),
    ("pose", lambda v: [v[0], v[1], v[2], v[3] + np.pi / 2], "90 degrees have to be taken from it"),
    ("pose", lambda v: [v[0], v[1], v[2], v[3] - np.pi / 2], "90 degrees have to be added to it"),
    ("pose", lambda v: [v[0], v[1], v[2], v[3] + np.pi], "off by 180 degrees"),
    ("pose", lambda v: [1000 * v[0], 1000 * v[1], 1000 * v[2], v[3]], "millimetres"),
    ("pose", lambda v: [100 * v[0], 100 * v[1], 100 * v[2], v[3]], "centimetres"),
    ("compass", lambda v: [np.pi / 2 - v[0]], "clockwise from north"),
    ("compass", lambda v: [-v[0]], "its sign is flipped"),
    ("compass", lambda v: [v[0] + np.pi / 2], "90 degrees have to be taken from it"),
    ("compass", lambda v: [v[0] + np.pi], "off by 180 degrees"),
    ("compass", lambda v: [v[0] * DEGREES], "in degrees"),
    ("pressure", lambda v: [v[0] / 100.0], "hectopascals"),
    ("pressure", lambda v: [v[0] / 1000.0], "kilopascals"),
    ("pressure", lambda v: [v[0] / 1e5], "bars"),
    ("pressure", lambda v: [v[0] - 101325.0], "counts from the surface"),
    ("imu", lambda v: [-v[0], v[1], -v[2], -v[3]], "forward-right-down"),
    ("imu", lambda v: [-v[0], v[1], v[2], v[3]], "sign of the yaw rate is flipped"),
    ("imu", lambda v: [v[0], -v[1], -v[2], -v[3]], "opposite sign"),
    ("imu", lambda v: [v[0], v[2], -v[1], v[3]], "x = -y, y = x"),
    ("imu", lambda v: [v[0] * DEGREES, v[1], v[2], v[3]], "degrees per second"),
    ("imu", lambda v: [v[0], v[1] / 9.81, v[2] / 9.81, v[3] / 9.81], "in g instead"),
    ("imu", lambda v: [v[0], v[1], v[2], v[3] - 9.81], "gravity is left out"),
    ("velocity", lambda v: [-v[0], -v[1], v[2]], "signs of x and y are flipped"),
    ("velocity", lambda v: [v[0], -v[1], -v[2]], "sign of z is flipped"),
    ("velocity", lambda v: [1000 * v[0], 1000 * v[1], 1000 * v[2]], "millimetres"),
    ("thruster_command", lambda v: [v[1], v[0], v[2]], "left and right are exchanged"),
    ("thruster_command", lambda v: [-v[0], -v[1], v[2]], "forwards and backwards are exchanged"),
    ("thruster_command", lambda v: [-v[1], -v[0], v[2]], "forwards and backwards are exchanged, and left and right"),
]


@pytest.mark.parametrize(("topic", "change", "words"), MIXUPS)
def test_a_mixup_among_all_streams(
    swum: Swum, swim: Any, lily_platform: Platform, topic: str, change: Callable[..., Any], words: str
) -> None:
    """Each is found alone, named, and put right, with five streams and the commands to compare."""
    clean = swum(swim(seed=3))
    wrong = mixed(clean, topic, change)
    (found,) = needed_corrections(wrong, lily_platform)
    assert found.topic == topic and words in found.wrong
    assert found.nats > 10.0
    right = corrected(wrong, [found])
    if topic == "thruster_command":
        np.testing.assert_allclose(right.command, clean.command, atol=1e-9)
        return
    given, expected = right.streams[topic], clean.streams[topic]
    turns = 2 * np.pi * np.rint((given.value - expected.value)[0] / (2 * np.pi)) * _is_angle(topic)
    np.testing.assert_allclose(given.value - turns, expected.value, rtol=1e-9, atol=1e-6)
    if words != "off by 180 degrees" and "surface" not in words and "left out" not in words:
        assert given.noise.shape == expected.noise.shape


def _is_angle(topic: str) -> np.ndarray:
    return {"pose": np.array([0, 0, 0, 1]), "compass": np.array([1])}.get(topic, np.zeros(1))


def test_a_velocity_in_world_axes(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """It is turned into body axes by the yaw of the poses."""
    clean = swum(swim(seed=4))
    (found,) = needed_corrections(in_world(clean), lily_platform)
    assert found.topic == "velocity" and "world axes" in found.wrong
    right = corrected(in_world(clean), [found]).streams["velocity"].value
    np.testing.assert_allclose(right, clean.streams["velocity"].value, atol=1e-9)


@pytest.mark.parametrize(
    ("topic", "change", "words"),
    [
        ("pose", lambda v: [v[0], -v[1], v[2], v[3]], "sign of y is flipped"),
        ("pose", lambda v: [v[1], v[0], v[2], v[3]], "x and y are swapped"),
        ("pose", lambda v: v, ""),
        ("pose", lambda v: [v[1], -v[0], v[2], v[3]], ""),
        ("velocity", lambda v: [-v[0], v[1], v[2]], ""),
    ],
)
def test_mirrored_poses_beside_velocities_alone(
    swum: Swum, swim: Any, lily_platform: Platform, topic: str, change: Callable[..., Any], words: str
) -> None:
    """A mirror image is told from a flipped velocity over all headings; what is turned may be the one or the other."""
    log = mixed(swum(swim(seed=5, topics=("pose", "velocity"))), topic, lambda v: np.asarray(change(v)))
    found = mirrored_poses(motion_together([log], lily_platform))
    if not words:
        assert found is None
        return
    assert found is not None and found.topic == "pose" and words in found.wrong and found.nats > 10.0


@pytest.mark.parametrize(
    ("topics", "change", "words"),
    [
        (("pose",), lambda v: [v[1], v[0], v[2], v[3]], "swapped"),
        (("pose",), lambda v: [v[1], v[0], -v[2], np.pi / 2 - v[3]], "north-east-down"),
        (("pose",), lambda v: [1000 * v[0], 1000 * v[1], 1000 * v[2], v[3]], "millimetres"),
        (("pose", "compass"), lambda v: [np.pi / 2 - v[0]], "clockwise from north"),
        (("pose", "compass"), lambda v: [v[0] * DEGREES], "in degrees"),
        (("pressure", "imu"), lambda v: [-v[0], v[1], -v[2], -v[3]], "forward-right-down"),
        (("imu",), lambda v: [-v[0], v[1], v[2], v[3]], "yaw rate is flipped"),
        (("imu", "compass"), lambda v: [-v[0]], "the heading"),
        (("pressure", "pose"), lambda v: [v[0], v[1], -v[2], v[3]], "z points down"),
        (("pose",), lambda v: [v[0], v[1], -v[2], v[3]], "z points down"),
        (("velocity",), lambda v: [-v[0], v[1], v[2]], "flipped"),
    ],
)
def test_a_mixup_among_few_streams(
    swum: Swum,
    swim: Any,
    lily_platform: Platform,
    topics: tuple[str, ...],
    change: Callable[..., Any],
    words: str,
) -> None:
    """One or two streams and the commands are enough; the last one is mixed up."""
    topic = topics[-1]
    wrong = mixed(swum(swim(seed=5, topics=topics)), topic, change)
    (found,) = needed_corrections(wrong, lily_platform)
    assert found.topic == topic and words in found.wrong


def north_east(values: Any) -> list[Any]:
    """Poses with x to the north and y to the east, yaw clockwise from north, and z still up: a mirror image."""
    return [values[1], values[0], values[2], np.pi / 2 - values[3]]


@pytest.mark.parametrize(
    ("topics", "fault", "rival"),
    [
        (("pose",), ("pose", north_east), "thruster_command"),
        # Commands that are exchanged make the same of poses alone.
        (("pose",), ("thruster_command", lambda v: [v[1], v[0], v[2]]), "thruster_command"),
        (("imu",), ("imu", lambda v: [-v[0], v[1], v[2], v[3]]), "thruster_command"),
        # A second stream that agrees with the commands decides.
        (("pose", "compass"), ("pose", north_east), ""),
        (("pose", "imu"), ("pose", north_east), ""),
        # So do other axes than those that an exchange makes.
        (("pose",), ("pose", lambda v: [v[1], v[0], v[2], v[3]]), ""),
        (("pose",), ("pose", lambda v: [v[1], v[0], -v[2], np.pi / 2 - v[3]]), ""),
        (("imu",), ("imu", lambda v: [-v[0], v[1], -v[2], -v[3]]), ""),
    ],
)
def test_exchanged_commands_are_told_where_they_explain_as_much(
    swum: Swum, swim: Any, lily_platform: Platform, topics: tuple[str, ...], fault: tuple[str, Any], rival: str
) -> None:
    """One stream and the commands tell that one of the two is mirrored, not which."""
    (found,) = needed_corrections(mixed(swum(swim(seed=5, topics=topics)), *fault), lily_platform)
    assert found.topic == topics[0] and found.rival == rival


SUBSETS = [TOPICS, ("pose",), ("pose", "compass"), ("compass", "imu"), ("pressure", "imu"), ("pose", "imu", "velocity")]


@pytest.mark.parametrize("seed", range(24))
def test_clean_logs_need_no_correction(swum: Swum, swim: Any, lily_platform: Platform, seed: int) -> None:
    """Whatever the motion, the current, the length, the subset of topics: nothing is suspected."""
    rng = np.random.default_rng(seed)
    drift = tuple(rng.normal(0.0, 0.02, 2)) if seed % 3 == 0 else (0.0, 0.0)
    duration = float(rng.choice([60.0, 120.0, 300.0]))
    log = swum(swim(100 + seed, duration, drift, SUBSETS[seed % len(SUBSETS)], straight=seed % 5 == 4))
    assert needed_corrections(log, lily_platform) == ()


def test_a_current_as_fast_as_the_robot_is_no_mixup(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """A robot that heads one way while the water carries it another one."""
    log = swum(swim(354, 600.0, (-0.022, -0.052), straight=True))
    assert needed_corrections(log, lily_platform) == ()


def test_a_world_turned_as_a_whole_is_no_mixup(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Poses and compass by another east contradict nothing."""
    log = mixed(swum(swim(seed=6)), "pose", lambda v: [-v[1], v[0], v[2], v[3] + np.pi / 2])
    assert needed_corrections(mixed(log, "compass", lambda v: [v[0] + np.pi / 2]), lily_platform) == ()


def test_too_little_motion_asks_for_no_correction(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Twenty seconds of a robot with a wrong compass are not enough to say so."""
    short = mixed(swum(swim(seed=7, duration=20.0)), "compass", lambda v: [-v[0]])
    assert needed_corrections(short, lily_platform) == ()


def test_a_short_log_with_a_wrong_velocity(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Twelve seconds are not enough to correct it."""
    short = mixed(swum(swim(seed=7, duration=12.0)), "velocity", lambda v: [-v[0], -v[1], v[2]])
    assert needed_corrections(short, lily_platform) == ()


def test_a_heading_that_counts_on_is_not_in_degrees(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Radians that go beyond a turn, because somebody has unwrapped them, swing as fast as the poses turn."""
    log = swum(swim(seed=8))
    counting = {**log.streams, "compass": replace(log.streams["compass"], full_turn=360.0)}
    assert needed_corrections(replace(log, streams=counting), lily_platform) == ()
    alone = replace(log, streams={"compass": counting["compass"]}, command_time=np.empty(0), command=np.empty((0, 3)))
    assert names(needed_corrections(alone, lily_platform)) == ["compass"]


def test_gravity_upside_down_alone(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Where nothing shows how the horizontal axes lie, only the axis of gravity is put right."""
    log = swum(swim(seed=8, topics=("imu",)))
    log = replace(log, command_time=np.empty(0), command=np.empty((0, 3)))
    (found,) = needed_corrections(mixed(log, "imu", lambda v: [v[0], v[1], v[2], -v[3]]), lily_platform)
    assert found.wrong == "the sign of its z axis is flipped"
    assert needed_corrections(mixed(log, "imu", lambda v: [v[0], v[1], v[2], 0.5 * v[3]]), lily_platform) == ()


@pytest.mark.parametrize(
    ("best", "count", "expected"), [(0.8, 20.0, 10.0 * np.log(4.0)), (0.3, 99.0, 0.0), (0.8, 7.0, 0.0)]
)
def test_nats_behind(best: float, count: float, expected: float) -> None:
    """n/2 ln((1 - 0.2) / (1 - 0.8)); nothing where the best explains too little, or where too few readings are."""
    behind = nats_behind(np.array([0.2, best]), best, count)
    np.testing.assert_allclose(behind, [expected, 0.0], atol=1e-12)


def test_several_at_once(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """A compass in degrees from north, pressure in hPa and an IMU upside down are three corrections."""
    log = mixed(swum(swim(seed=8)), "compass", lambda v: [90.0 - v[0] * DEGREES])
    log = mixed(log, "pressure", lambda v: [v[0] / 100.0])
    log = mixed(log, "imu", lambda v: [-v[0], v[1], -v[2], -v[3]])
    found = needed_corrections(log, lily_platform)
    assert [correction.topic for correction in found] == ["compass", "pressure", "compass", "imu"]
    assert needed_corrections(corrected(log, found), lily_platform) == ()


def test_noise_is_corrected_too(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Scales scale it; exchanged axes exchange it."""
    log = swum(swim(seed=9))
    wrong = mixed(log, "pose", lambda v: [1000 * v[1], 1000 * v[0], 1000 * v[2], v[3]])
    stream = wrong.streams["pose"]
    wrong = replace(wrong, streams={**wrong.streams, "pose": replace(stream, noise=np.array([2.0, 1.0, 3.0, 0.02]))})
    right = corrected(wrong, needed_corrections(wrong, lily_platform)).streams["pose"].noise
    np.testing.assert_allclose(right, [0.001, 0.002, 0.003, 0.02], rtol=1e-9)


def test_columns_that_are_not_given_stay_so(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """A camera without heading: the rest is put right, the yaw stays unknown."""
    log = mixed(swum(swim(seed=9)), "pose", lambda v: [v[0], v[1], -v[2], np.full(v.shape[1], np.nan)])
    right = corrected(log, needed_corrections(log, lily_platform)).streams["pose"].value
    assert np.isnan(right[:, 3]).all()
    assert np.isfinite(right[:, :3]).all() and (right[:, 2] < 0.0).any()


def names(found: Sequence[Any]) -> list[str]:
    """The topics of corrections."""
    return [correction.topic for correction in found]


def test_an_imu_on_its_side_is_said(swum: Swum, swim: Any, lily_platform: Platform) -> None:
    """Gravity along x: said, but no matrix can help, because the rate about that axis was not read."""
    log = mixed(swum(swim(seed=9)), "imu", lambda v: [np.zeros(v.shape[1]), v[3], v[2], v[1]])
    (found,) = needed_corrections(log, lily_platform)
    assert found.topic == "imu" and "along its x axis" in found.because and found.matrix is None
    assert corrected(log, [found]) == log


def spiral(number: int) -> RobotLog:
    """A blimp that turns left under one command throughout, the faster the greater `number`."""
    rate, speed = 0.6 + 0.1 * number, 0.5 + 0.05 * number
    time = np.arange(0.0, 60.0, 0.05)
    yaw = rate * time
    place = [speed / rate * np.sin(yaw), -speed / rate * np.cos(yaw)]
    pose = np.column_stack([*place, -0.01 * time, yaw])
    pose += 0.001 * np.random.default_rng(number).standard_normal(pose.shape)
    command = np.tile([0.2, 0.6 + 0.05 * number], (len(time), 1))
    return RobotLog("blimp", time, command, {"pose": Stream(time, pose, np.full(4, 0.001))})


def test_a_hull_that_is_led_through_a_spiral_is_no_mixup() -> None:
    """Wings let a blimp fly where it points, while drag by the total speed alone would let it slip a quarter turn."""
    logs = [spiral(number) for number in range(3)]
    assert needed_corrections(logs, load_platform("rgblimp")) == ()
    quarter = [mixed(log, "pose", lambda v: [v[0], v[1], v[2], v[3] - np.pi / 2]) for log in logs]
    (correction,) = needed_corrections(quarter, load_platform("rgblimp"))
    assert "90 degrees have to be added" in correction.wrong


def test_right_recordings_tell_which_of_two_streams_is_mirrored() -> None:
    """Under one command throughout, a mirrored place and a mirrored yaw differ in the side alone that it turns to."""
    blimp, right = load_platform("rgblimp"), [spiral(number) for number in range(3)]
    place = mixed(right[1], "pose", lambda v: [v[0], -v[1], v[2], v[3]])
    yaw = mixed(right[1], "pose", lambda v: [v[0], v[1], v[2], -v[3]])
    alone = [needed_corrections(log, blimp) for log in (place, yaw)]
    assert [found.wrong for found in alone[0]] == [found.wrong for found in alone[1]]
    (of_place,), (of_yaw,) = (needed_corrections(log, blimp, right) for log in (place, yaw))
    assert of_place.wrong == "the sign of y is flipped"
    assert of_yaw.wrong == "as to the yaw, its sign is flipped (clockwise positive)"
    assert needed_corrections(right[1], blimp, right) == ()


@pytest.mark.parametrize(
    ("topic", "change", "words"),
    [
        ("pose", lambda v: [1000 * v[0], 1000 * v[1], 1000 * v[2], v[3]], "millimetres"),
        ("pressure", lambda v: [v[0] / 100.0], "hectopascals"),
    ],
)
def test_depths_that_a_map_made_pressures_weigh_as_in_fresh_water(
    lily_platform: Platform, swum: Swum, swim: Any, topic: str, change: Any, words: str
) -> None:
    """By the weight of a fluid five times as dense, heights and pressures would be in no unit that there is."""
    log = swum(swim(topics=("pose", "pressure")))
    log = replace(log, streams={**log.streams, "pressure": replace(log.streams["pressure"], from_depth=True)})
    log, dense = mixed(log, topic, change), replace(lily_platform, water_density=5000.0)
    motion = motion_together([log], dense)
    found = pressure_unit([log], motion, dense) if topic == "pressure" else height_unit([log], motion, dense)
    assert found is not None and words in found.wrong
