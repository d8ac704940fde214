"""Corrections of streams whose numbers are so large or small that they must be in another unit."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import KINEMATICS, UNITS
from cocorosim_ros.diagnosis.evidence.frames.agreement import correlation, independent, slope
from cocorosim_ros.diagnosis.evidence.frames.correction import CERTAIN, Fault, FrameCorrection, affine, scaled
from cocorosim_ros.diagnosis.evidence.frames.kinematics import noise_weight
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import AMBIENT
from cocorosim_ros.diagnosis.evidence.streams.turning import FULL_TURN
from cocorosim_ros.diagnosis.evidence.streams.vehicle_scales import pressure_per_metre
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.world.state.pressure import SURFACE_PRESSURE

DEGREE = np.pi / 180.0


def heading_in_degrees(logs: Sequence[RobotLog], motion: ShownMotion) -> FrameCorrection | None:
    """The correction of a compass in degrees, which swings too fast or reads more than 2 pi; None for radians."""
    streams = [log.streams["compass"] for log in logs if "compass" in log.streams]
    words = "the heading is in degrees instead of radians"
    for rate, name in ((motion.turn, "the poses turn"), (motion.gyro, "the gyroscope says")):
        ratio = _ratio(motion.swing, rate, motion)
        if UNITS.degrees[0] < ratio < UNITS.degrees[1]:
            return scaled("compass", Fault(words, f"it swings {ratio:.3g} times as fast as {name}"), CERTAIN, [DEGREE])
        if np.isfinite(ratio):
            return None
    if all(stream.full_turn == FULL_TURN for stream in streams):
        return None
    return scaled("compass", Fault(words, "its readings go beyond a whole turn of 6.28 rad"), CERTAIN, [DEGREE])


def rate_in_degrees(motion: ShownMotion) -> FrameCorrection | None:
    """The correction of a gyroscope in degrees per second, by the rate of the heading; None for radians per second."""
    for rate, name in ((motion.turn, "the poses"), (motion.swing, "the compass")):
        ratio = _ratio(motion.gyro, rate, motion)
        if UNITS.degrees[0] < ratio < UNITS.degrees[1]:
            because = f"its rate is {ratio:.3g} times that at which {name} turns"
            fault = Fault("the angular rate is in degrees per second instead of radians", because)
            return scaled("imu", fault, CERTAIN, [DEGREE, 1.0, 1.0, 1.0])
        if np.isfinite(ratio):
            return None
    return None


def pressure_unit(logs: Sequence[RobotLog], motion: ShownMotion, platform: Platform) -> FrameCorrection | None:
    """The correction of a pressure that is not in pascals, or counts from the surface; None if it is absolute."""
    readings = [log.streams["pressure"].value[:, AMBIENT] for log in logs if "pressure" in log.streams]
    if not readings or platform.water_density < UNITS.dense:
        return None
    level = float(np.median(np.concatenate(readings)))
    if level >= UNITS.absolute:
        return None
    per_metre = _ratio(motion.sinking, motion.climb, motion)
    weight, (shallow, steep) = _weight(logs, platform), UNITS.pressure_slope
    for unit, factor, (low, high) in UNITS.pressures:
        fits = np.isnan(per_metre) or shallow < per_metre * factor / weight < steep
        if low <= level < high and fits:
            because = f"its median is {level:.4g} where the surface alone makes {SURFACE_PRESSURE:.0f} Pa"
            fault = Fault(f"the pressure is in {unit} instead of pascals", because)
            return scaled("pressure", fault, CERTAIN, [factor])
    if not np.isnan(per_metre) and not shallow < per_metre / weight < steep:
        return None
    because = f"its median is {level:.4g} Pa, less than the {SURFACE_PRESSURE:.0f} Pa of the air"
    fault = Fault("the pressure counts from the surface instead of from vacuum", because)
    return affine("pressure", fault, CERTAIN, np.eye(1), np.array([SURFACE_PRESSURE]))


def _ratio(left: Floats, right: Floats, motion: ShownMotion) -> float:
    """Size of `left` in multiples of `right`, two rates of one motion, where they are clearly related; else NaN."""
    found = abs(correlation(left, right).real)
    related = found > UNITS.related and independent(left, right, motion.weight) >= UNITS.fewest
    exact = found > KINEMATICS.exact and independent(left, right, noise_weight(motion)) >= KINEMATICS.fewest
    return abs(slope(left, right)) if related or exact else float("nan")


def height_unit(logs: Sequence[RobotLog], motion: ShownMotion, platform: Platform) -> FrameCorrection | None:
    """The correction of poses in another unit than metres, by the pressure; None for metres."""
    if platform.water_density < UNITS.dense:
        return None
    metres = motion.sinking / _weight(logs, platform)
    ratio = _ratio(motion.climb, metres, motion)
    return _length("pose", ratio, "the pressure lets")


def _weight(logs: Sequence[RobotLog], platform: Platform) -> float:
    """Pressure per metre [Pa/m] that most of the logs show, of those with a pressure if there are any."""
    shown = [log for log in logs if "pressure" in log.streams] or logs
    return float(np.median([pressure_per_metre(platform, log) for log in shown]))


def length_unit(
    topic: str, measured: Floats, expected: Floats, motion: ShownMotion, source: str
) -> FrameCorrection | None:
    """The correction of speeds `measured` (n,) in another unit of length than those `expected` (n,) from `source`."""
    given = np.isfinite(measured) & np.isfinite(expected)
    if independent(measured, expected, motion.weight) < UNITS.fewest or not np.any(expected[given] > 0.0):
        return None
    return _length(topic, float(np.sqrt(np.mean(measured[given] ** 2) / np.mean(expected[given] ** 2))), source)


def _length(topic: str, ratio: float, source: str) -> FrameCorrection | None:
    for unit, factor, (low, high) in UNITS.lengths:
        if low < ratio < high:
            because = f"its speeds are {ratio:.3g} times those that {source} one expect"
            columns = [factor] * 3 + [1.0] * (topic == "pose")
            return scaled(topic, Fault(f"lengths are in {unit} instead of metres", because), CERTAIN, columns)
    return None
