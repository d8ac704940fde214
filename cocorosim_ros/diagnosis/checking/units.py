"""Units, axes and signs that the numbers of standard messages contradict."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import numpy as np

from cocorosim_ros.diagnosis.checking.covariances import first_variances
from cocorosim_ros.diagnosis.checking.finding import Oddity
from cocorosim_ros.diagnosis.checking.motion import (
    averaged,
    averages_of,
    rate_of,
    rates_of,
    slope_and_correlation,
    turned,
)
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog
from cocorosim_ros.diagnosis.criteria.checking import ACCELERATIONS, CHECKING
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.units import units_in_files
from cocorosim_ros.scenario.reading.entry import listed
from cocorosim_ros.wire.conversion.doubts import like_degrees
from cocorosim_ros.world.sensors.pose import yaw_of_quaternions

_HEADINGS = re.compile(r"(heading|compass|yaw)", re.IGNORECASE)
_POSES = ("pose", "pose.pose")
_RATES = ("angular_velocity.z", "twist.twist.angular.z")


def check_units(topic: TopicLog) -> Iterator[Oddity]:
    """Look at one topic by itself."""
    for sentence in (
        *(_quaternion(topic, path) for path in topic.quaternions),
        _acceleration(topic),
        *(_turning(topic, path) for path in _RATES),
        *(_turning_of_track(topic, path) for path in _POSES),
        _velocity(topic),
        _pressure(topic),
        _heading(topic),
    ):
        if sentence:
            yield Oddity("units", topic.name, f"{topic.name}: {sentence}")


def check_depths(topics: Sequence[TopicLog]) -> Iterator[Oddity]:
    """Look whether z goes up where the pressure rises."""
    pressures = [topic for topic in topics if topic.has("fluid_pressure")]
    for topic in topics:
        place = topic.vector("pose.pose.position")
        place = topic.vector("pose.position") if place is None else place
        if place is None or len(place) < CHECKING.fewest:
            continue
        own = [each for each in pressures if len(pressures) == 1 or _namespace(each) == _namespace(topic)]
        for pressure in own:
            seen = np.interp(topic.log_ns, pressure.log_ns, pressure.number("fluid_pressure"))
            slope, related = slope_and_correlation(seen, place.T[2])
            if related > CHECKING.related and slope > 0.0 and np.ptp(place.T[2]) > CHECKING.moving:
                words = f"its z grows with the pressure of {pressure.name}: z is down, where REP 103 has it up."
                yield Oddity("units", topic.name, f"{topic.name}: {words}")


def _namespace(topic: TopicLog) -> str:
    return topic.name.strip("/").partition("/")[0]


def _quaternion(topic: TopicLog, path: str) -> str:
    turn = topic.vector(path, "xyzw")
    if turn is None or (topic.type_name.endswith("/Imu") and _says_nothing(topic, path)):
        return ""
    length = np.linalg.norm(turn, axis=1)
    off = np.abs(length - 1.0) > CHECKING.unit_quaternion
    if off.any():
        zero = np.count_nonzero(length == 0.0)
        other = f"have another length than 1, {length[off][0]:.3g} first"
        what = "are zero" if zero == np.count_nonzero(off) else other
        return f"{np.count_nonzero(off)} of {len(off)} quaternions of {path} {what}."
    x, y, _, _ = turn.T
    upright = np.median(1.0 - 2.0 * (x**2 + y**2))
    if upright < math.cos(CHECKING.lying):
        how = "upside down" if upright < CHECKING.upside_down else "on its side"
        return f"{path} has the vehicle {how} most of the time: axes are mixed up, or x, y, z, w are in another order."
    return ""


def _says_nothing(topic: TopicLog, path: str) -> bool:
    covariance = topic.covariances.get(f"{path}_covariance")
    return covariance is not None and bool((first_variances(covariance) == -1.0).all())


def _acceleration(topic: TopicLog) -> str:
    felt = topic.vector("linear_acceleration")
    if felt is None or len(felt) < CHECKING.fewest or not np.isfinite(felt).all(axis=1).any():
        return ""
    felt = felt[np.isfinite(felt).all(axis=1)]
    size, up = float(np.median(np.linalg.norm(felt, axis=1))), float(np.median(felt.T[2]))
    unit = next((unit for unit, (low, high) in ACCELERATIONS.items() if low <= size <= high), None)
    if unit == "g":
        return f"its acceleration is {size:.2f} in the median: it is in g, where sensor_msgs/Imu has m/s^2."
    if unit is None:
        at_rest = float(units_in_files()["acceleration"]["g0"])
        gravity = "gravity is left out of it" if size < min(ACCELERATIONS["g"]) else "its unit or scale is another"
        return f"its acceleration is {size:.3g} m/s^2 in the median, not {at_rest:.2f}: {gravity}."
    if up < CHECKING.upside_down * size:
        return f"at rest it shows {up:.2f} m/s^2 along z: z is down, where REP 103 has it up."
    return ""


def _turning(topic: TopicLog, path: str) -> str:
    turn = topic.vector(_attitude_beside(path), "xyzw")
    if turn is None or not topic.has(path) or len(turn) < CHECKING.fewest:
        return ""
    time, rate = topic.time(), topic.number(path)
    seen = rate_of(time, np.unwrap(yaw_of_quaternions(turn)))
    return _compared(path, "the turning of its own attitude", averaged(time, rate), seen, degrees=True)


def _turning_of_track(topic: TopicLog, path: str) -> str:
    """A sentence if a pose turns 57 times as its direction of travel does, which no current or drift makes."""
    place, turn = topic.vector(f"{path}.position", "xy"), topic.vector(f"{path}.orientation", "xyzw")
    if place is None or turn is None or len(place) < CHECKING.fewest:
        return ""
    time = topic.time()
    course = np.unwrap(np.arctan2(*rates_of(time, place).T[::-1]))
    time, heading = time[: len(course)], np.unwrap(yaw_of_quaternions(turn))[: len(course)]
    seen, told = rate_of(time, course), rate_of(time, heading)
    slope, related = slope_and_correlation(seen, told)
    moving = float(np.std(seen)) >= CHECKING.moving and related > CHECKING.related
    if not moving or not 1.0 / CHECKING.ratio < slope / math.degrees(1.0) < CHECKING.ratio:
        return ""
    return f"{path}.orientation turns {slope:.0f} times as its track does: it was made of degrees taken for radians."


def _attitude_beside(path: str) -> str:
    return "orientation" if path.startswith("angular") else "pose.pose.orientation"


def _velocity(topic: TopicLog) -> str:
    place, turn = topic.vector("pose.pose.position", "xy"), topic.vector("pose.pose.orientation", "xyzw")
    told = topic.vector("twist.twist.linear", "xy")
    if place is None or turn is None or told is None or len(place) < CHECKING.fewest:
        return ""
    time = topic.time()
    over_ground, mean = rates_of(time, place), averages_of(time, told)
    heading = np.unwrap(yaw_of_quaternions(turn))
    in_body = turned(over_ground, -averaged(time, heading))
    _, by_body = slope_and_correlation(in_body.ravel(), mean.ravel())
    _, by_world = slope_and_correlation(over_ground.ravel(), mean.ravel())
    if by_world > CHECKING.related > by_body and by_world > by_body:
        return "its twist is in the axes of the world; nav_msgs/Odometry has it in those of child_frame_id."
    return _compared("twist.twist.linear", "the motion of its own pose", mean.ravel(), in_body.ravel(), degrees=False)


def _compared(path: str, beside: str, told: Floats, seen: Floats, *, degrees: bool) -> str:
    """A sentence if two numbers of one motion differ in size or sign."""
    slope, related = slope_and_correlation(seen, told)
    if float(np.std(seen)) < CHECKING.moving or abs(related) < CHECKING.related:
        return ""
    size = abs(slope)
    if degrees and 1.0 / CHECKING.ratio < size / math.degrees(1.0) < CHECKING.ratio:
        return f"{path} is {size:.1f} times {beside}: it is in degrees, where ROS has radians."
    if slope < 0.0:
        return f"{path} goes against {beside}: its sign or its axes are turned."
    if not 1.0 / CHECKING.ratio < size < CHECKING.ratio:
        return f"{path} is {size:.3g} times {beside}: unit or scale of one of them is another."
    return ""


def _pressure(topic: TopicLog) -> str:
    if not topic.has("fluid_pressure"):
        return ""
    usual = float(np.nanmedian(topic.numbers("fluid_pressure")))
    if usual >= CHECKING.smallest_air:
        return ""
    least, most = CHECKING.smallest_air, CHECKING.largest_pressure
    known = units_in_files()["pressure"].items()
    fitting = [unit for unit, factor in known if least <= usual * float(factor) <= most]
    guess = f"it may be in {listed(fitting)}, or without the air's" if fitting else "it is without the air's"
    return f"its pressure is {usual:.4g} in the median, less than that of the air in Pa: {guess}."


def _heading(topic: TopicLog) -> str:
    column = next((path for path in topic.columns if path == "heading"), None)
    if column is None and topic.columns == ("data",) and _HEADINGS.search(topic.name):
        column = "data"
    if column is None or not len(topic.values):
        return ""
    largest = float(np.nanmax(np.abs(topic.numbers(column)), initial=0.0))
    if largest <= 2.0 * math.pi + CHECKING.unit_quaternion:
        return ""
    found = "it is in degrees" if like_degrees(topic.number(column)) else "it is in degrees, or was never wrapped"
    return f"{column} reaches {largest:.1f}: {found}; ROS has radians."
