"""Streams of one vehicle beside each other: whether units, signs and axes that were taken agree with its motion."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.checking.motion import (
    averaged,
    averages_of,
    rate_of,
    rates_of,
    slope_and_correlation,
    turned,
)
from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.diagnosis.criteria.guessing import GUESSING
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import OVER_GROUND, THROUGH_WATER, VELOCITIES
from cocorosim_ros.diagnosis.guessing.column_names import is_heading
from cocorosim_ros.diagnosis.guessing.log_table import Guess
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors.pose import yaw_of_quaternions

_DOWN = "z of the pose grows with the depth: z is down, so its axes are taken to be north-east-down."
_OR_OVER_GROUND = (
    "Nothing says that the velocity is the one through the water, for which it is taken. From a Doppler log with "
    "bottom track, satellites or motion capture it is that over ground: then rename "
    f"'{THROUGH_WATER}' to '{OVER_GROUND}'."
)
_POSE, _PRESSURE, _IMU = "pose", "pressure", "imu"


def agreed(guesses: Sequence[Guess]) -> list[Guess]:
    """The streams of one vehicle with what its motion says about their axes, signs and units; contradictions said."""
    by_topic = {guess.topic: guess for guess in guesses}
    if _IMU in by_topic:
        by_topic[_IMU] = _by_gravity(by_topic[_IMU])
    if THROUGH_WATER in by_topic:
        by_topic[THROUGH_WATER] = by_topic[THROUGH_WATER].doubting(_OR_OVER_GROUND)
    pose = by_topic.get(_POSE)
    if pose is None or len(pose.table.time) < CHECKING.fewest:
        return list(by_topic.values())
    pose = by_topic[_POSE] = _compass_or_yaw(_by_depth(pose, by_topic.get(_PRESSURE)))
    for topic in (each for each in VELOCITIES if each in by_topic):
        found = _by_motion(by_topic[topic], pose)
        by_topic = {**by_topic, topic: found} if found.numbers else _without(by_topic, found)
    for topic, name in ((_IMU, "rate_z"), *((each, "yaw_rate") for each in VELOCITIES)):
        if topic in by_topic and name in by_topic[topic].numbers:
            by_topic[topic] = _by_turning(by_topic[topic], name, by_topic[_POSE])
    return list(by_topic.values())


def _without(by_topic: dict[str, Guess], left_out: Guess) -> dict[str, Guess]:
    """The streams without one, whose doubts the pose then tells."""
    kept = {topic: guess for topic, guess in by_topic.items() if topic != left_out.topic}
    return {**kept, _POSE: kept[_POSE].doubting(*left_out.doubts)}


def yaw_in(pose: Guess) -> Floats | None:
    """(n,) headings of a pose [rad], in its own axes; None where it has none."""
    if "yaw" in pose.numbers:
        return np.unwrap(pose.numbers["yaw"].in_si())
    if "qw" not in pose.numbers:
        return None
    turn = np.column_stack([pose.numbers[name].in_si() for name in ("qx", "qy", "qz", "qw")])
    return np.asarray(np.unwrap(yaw_of_quaternions(turn)))


def _by_gravity(imu: Guess) -> Guess:
    """Axes by the direction in which an accelerometer at rest shows gravity."""
    number = imu.numbers.get("acceleration_z")
    if number is None or len(number.values) < CHECKING.fewest:
        return imu
    felt = number.in_si()
    up = float(np.nanmedian(felt))
    if up >= CHECKING.upside_down * float(np.nanmedian(np.abs(felt))) or imu.north_east_down:
        return imu
    words = "At rest z of its acceleration is negative: z is down, so its axes are taken to be north-east-down."
    return replace(imu, north_east_down=True).doubting(words)


def _by_depth(pose: Guess, pressure: Guess | None) -> Guess:
    """Axes by a depth or pressure beside the pose."""
    if "z" not in pose.numbers or pose.north_east_down:
        return pose
    height = pose.numbers["z"].in_si()
    if pressure is not None:
        deep = next(iter(pressure.numbers.values()))
        seen = np.interp(pose.table.time, pressure.table.time, deep.in_si())
        _, related = slope_and_correlation(seen, height)
        if abs(related) > CHECKING.related and np.ptp(height) > CHECKING.moving:
            return replace(pose, north_east_down=True).doubting(_DOWN) if related > 0.0 else pose
    if not pose.table.kind and float(np.nanmedian(height)) > CHECKING.moving:
        words = (
            "z of the pose is above zero most of the time and nothing tells whether it is a depth; it is taken as up."
        )
        return pose.doubting(words)
    return pose


def _compass_or_yaw(pose: Guess) -> Guess:
    """Turn a bearing, which counts clockwise from north, where the direction of travel says that the yaw is one."""
    yaw = yaw_in(pose)
    if yaw is None or not {"x", "y", "yaw"} <= pose.numbers.keys():
        return pose
    time, place = pose.table.time, _place(pose)
    steps = rates_of(time, place)
    speed = np.hypot(*steps.T)
    moves = speed > max(CHECKING.moving, GUESSING.under_way * float(np.nanmax(speed, initial=0.0)))
    # Columns that are picked are copies: NumPy 1.26 rounds the arctangent of strided ones by where its result lies.
    course, heading = np.arctan2(steps[moves, 1], steps[moves, 0]), averaged(time, yaw)[moves]
    name = pose.numbers["yaw"].column
    if len(course) < CHECKING.fewest or np.ptp(heading) < GUESSING.turned_enough:
        return _by_its_name(pose)
    as_yaw, as_bearing = (complex(np.mean(np.exp(1j * (course - sign * heading)))) for sign in (1.0, -1.0))
    if abs(as_bearing) > CHECKING.related > abs(as_yaw):
        quarters = round(2.0 * cmath.phase(as_bearing) / math.pi)
        number = replace(pose.numbers["yaw"], negated=True, quarters=quarters)
        words = f"'{name}' counts clockwise from where y points, as the direction of travel says."
        return pose.with_number("yaw", number).doubting(words)
    if abs(as_yaw) > CHECKING.related and abs(cmath.phase(as_yaw)) > GUESSING.turned_enough:
        off = math.degrees(cmath.phase(as_yaw))
        return pose.doubting(f"The vehicle travels {off:.0f} deg off '{name}': its zero may be another.")
    return pose if abs(as_yaw) > CHECKING.related else _by_its_name(pose)


def _by_its_name(pose: Guess) -> Guess:
    """Take for a bearing what is called as a compass calls it, in degrees from 0 to 360; else for a yaw."""
    number = pose.numbers["yaw"]
    turns = number.in_si()
    name = number.column
    if not is_heading(name) or number.unit != "deg" or np.nanmin(turns) < 0.0 or np.nanmax(turns) < math.pi:
        return pose.doubting(
            f"Nothing says which way '{name}' counts; it is taken to count counter-clockwise from where x points. A "
            "bearing, clockwise from where y points, needs scale: -1 and offset: 90 deg."
        )
    words = (
        f"Its name and degrees from 0 to 360 alone say which way '{name}' counts; it is taken for a bearing, clockwise "
        "from where y points. A yaw, counter-clockwise from where x points, needs neither scale nor offset."
    )
    return pose.with_number("yaw", replace(number, negated=True, quarters=1)).doubting(words)


def _place(pose: Guess) -> Floats:
    return np.column_stack([pose.numbers[name].in_si() for name in ("x", "y")])


def _by_motion(velocity: Guess, pose: Guess) -> Guess:
    """A velocity beside the rate of the pose: in the axes of the body or of the world, in which unit and sign."""
    yaw = yaw_in(pose)
    if yaw is None or not {"x", "y"} <= velocity.numbers.keys():
        return velocity
    time, place = pose.table.time, _place(pose)
    told = np.column_stack(
        [np.interp(time, velocity.table.time, velocity.numbers[name].in_si()) for name in ("x", "y")]
    )
    over_ground, mean = rates_of(time, place), averages_of(time, told)
    in_body = turned(over_ground, -averaged(time, yaw))
    slope, by_body = slope_and_correlation(in_body.ravel(), mean.ravel())
    _, by_world = slope_and_correlation(over_ground.ravel(), mean.ravel())
    if by_world > CHECKING.related and by_world > by_body:
        words = "The velocity is that of the pose in the axes of the world, not of the body; it is left out."
        return replace(velocity, numbers={}).doubting(words)
    if float(np.std(in_body)) < CHECKING.moving or abs(by_body) < CHECKING.related:
        return velocity.doubting(
            "The motion of the pose neither confirms nor contradicts axes and unit of the velocity."
        )
    down = replace(velocity, north_east_down=velocity.north_east_down or pose.north_east_down)
    if slope < 0.0:
        return down.doubting("The velocity goes against the motion of the pose: its sign or its axes are turned.")
    scale = next((unit for unit, size in (("cm/s", 100.0), ("mm/s", 1000.0)) if _near(slope / size)), "")
    if scale and not any(number.sure for number in down.numbers.values()):
        numbers = {
            n: replace(part, unit=scale) if part.dimension == "speed" else part for n, part in down.numbers.items()
        }
        return replace(down, numbers=numbers)
    return down if _near(slope) else down.doubting(f"The velocity is {slope:.3g} times the motion of the pose.")


def _by_turning(guess: Guess, name: str, pose: Guess) -> Guess:
    """A yaw rate beside the rate of the heading: its unit and the axes of its stream."""
    yaw, number, time = yaw_in(pose), guess.numbers[name], pose.table.time
    if yaw is None:
        return guess
    told = averaged(time, np.interp(time, guess.table.time, number.in_si()))
    seen = rate_of(time, yaw)
    slope, related = slope_and_correlation(seen, told)
    if float(np.std(seen)) < CHECKING.moving or abs(related) < CHECKING.related:
        return guess
    if _near(abs(slope) / math.degrees(1.0)) or _near(abs(slope) / math.radians(1.0)):
        right = "deg/s" if abs(slope) > 1.0 else "rad/s"
        rates = {
            n: replace(part, unit=right) for n, part in guess.numbers.items() if part.dimension == number.dimension
        }
        words = f"'{number.column}' is in {right}, as the turning of the pose says."
        guess = replace(guess, numbers={**guess.numbers, **rates}).doubting(words)
    other_axes = bool(guess.north_east_down) != bool(pose.north_east_down)
    if (slope > 0.0) == other_axes:
        guess = replace(guess, north_east_down=not guess.north_east_down)
        return guess.doubting(
            f"'{number.column}' goes against the turning of the pose: z of one of them is taken as down."
        )
    return guess


def _near(ratio: float) -> bool:
    return 1.0 / CHECKING.ratio < ratio < CHECKING.ratio
