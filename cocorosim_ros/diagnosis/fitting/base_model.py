"""Numbers that every model of the recordings has: the platform's, those of them that are fitted, and the noise.

Mass is not fitted: forces, drag and inertia are known relative to mass alone. RECALIBRATED lists the fitted numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import FIRST_NOISE, FULL_FORCES, RANDOMNESS, RECALIBRATION
from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM
from cocorosim_ros.diagnosis.fitting.declared_numbers import is_steered_alone
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, RANDOM_FORCE, READING, Owner, Unknown, log_deviation
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import (
    COLUMN,
    NOISE_UNITS,
    READING_NOISE,
    READING_NOISE_OF_KIND,
)
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import full_forces, slowness
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.ranges import Ranges
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.vehicle_model.vehicles import PARAMETER_COLUMNS

# By column: the name that the contract reports, and the unit.
RECALIBRATED: dict[str, tuple[str, str]] = {
    "thrust_gain": ("thrust_gain", "1"),
    "yaw_torque_gain": ("yaw_torque_gain", "1"),
    "drag": ("drag", "kg/m"),
    "yaw_drag": ("yaw_drag", "N m s^2"),
    "yaw_inertia": ("inertia", "kg m^2"),
    "buoyancy_gain": ("buoyancy_gain", "1"),
}
OF_ALL_THRUSTERS = ("thrust_gain", "yaw_torque_gain")  # which thrusters with gains of their own do not need


@dataclass(frozen=True)
class Prior:
    """Prior of a logarithm, relative to the value at which the fit begins: standard deviation and bounds."""

    spread: float
    bounds: tuple[float, float]


_OF_FORCE = Prior(FIRST_NOISE.force_prior, (-FIRST_NOISE.farthest, FIRST_NOISE.farthest))
WATER_PRIOR = {
    "random.force": _OF_FORCE,
    "random.heave_force": _OF_FORCE,
    "random.moment": _OF_FORCE,
    "random.correlation": Prior(
        FIRST_NOISE.correlation_prior,
        (-FIRST_NOISE.farthest, math.log(RANDOMNESS.most_correlation / FIRST_NOISE.correlation)),
    ),
    "random.smoothness": Prior(
        FIRST_NOISE.smoothness_prior,
        (math.log(RANDOMNESS.least_smoothness / FIRST_NOISE.smoothness), -math.log(FIRST_NOISE.smoothness)),
    ),
}
"""Priors of the random forces, by column."""
SHARED_NOISE = ("random.correlation", "random.smoothness")
LEAST_READING_NOISE = {f"reading.{kind.noise or kind.name}": kind.least_noise for kind in KINDS.values()}
"""Least noise of a reading, by column."""


def base_rows(tracks: Sequence[Track]) -> Floats:
    """Rows (tracks, columns) of the plain model: the platform's numbers, no effects, the first guess of the noise.

    Units are SI; noise is the logarithm of it. The noise of readings is the one that `evidence` estimated from the high
    differences of each stream.
    """
    rows = np.array([track.vehicle.row for track in tracks])
    for row, track in zip(rows, tracks, strict=True):
        full = full_forces(track.vehicle)
        row[COLUMN["random.force"]] = math.log(FIRST_NOISE.disturbance * full.across)
        row[COLUMN["random.heave_force"]] = math.log(FIRST_NOISE.disturbance * full.random_heave)
        row[COLUMN["random.moment"]] = math.log(FIRST_NOISE.disturbance * max(full.yaw, FULL_FORCES.arm * full.across))
        row[COLUMN["random.correlation"]] = math.log(slowness(track.vehicle) * FIRST_NOISE.correlation)
        row[COLUMN["random.smoothness"]] = math.log(FIRST_NOISE.smoothness)
        for name, kinds in KINDS_OF_STREAM.items():
            if name not in track.log.streams:
                continue
            noise = track.log.streams[name].noise
            for column, kind in enumerate(kinds):
                if np.isfinite(noise[column]):
                    of_reading = f"reading.{READING_NOISE_OF_KIND[kind]}"
                    level = max(float(noise[column]), LEAST_READING_NOISE[of_reading])
                    row[COLUMN[of_reading]] = math.log(level)
    return rows


def base_unknowns(tracks: Sequence[Track]) -> list[Unknown]:
    """Unknowns of recalibration: the numbers of each robot's platform that are fitted, but for those kept as given."""
    found = []
    for robot, numbers in tracks_by_robot(tracks).items():
        vehicle = tracks[numbers[0]].vehicle
        ranges = vehicle.ranges
        alone = is_steered_alone(vehicle)
        for column, (name, unit) in RECALIBRATED.items():
            if column in vehicle.kept or (alone and column in OF_ALL_THRUSTERS):
                continue
            base = float(vehicle.nominal[PARAMETER_COLUMNS[column]])
            # Moments are known relative to the inertia alone, as forces are to the mass: inertia stays unless the file
            # gives its range.
            if base > 0.0 and (column != "yaw_inertia" or column in ranges):
                prior = _prior(column, ranges)
                owner = Owner(PLATFORM, (robot,), name, unit)
                bounds = _bounds(column, base, ranges)
                stated = _stated(column, vehicle.intervals)
                found.append(
                    Unknown(owner, column, numbers, base, logarithmic=True, prior=prior, bounds=bounds, stated=stated)
                )
    return found


def _bounds(column: str, base: float, ranges: Ranges) -> tuple[float, float]:
    """Bounds of the logarithm of a number over `base`: the range that the platform's file gives, else the usual ones.

    A gain of all thrusters has the range of the one whose maximum may change least (`vehicle_model.gain_ranges`). A
    number of the file that lies beyond its range, as that of a single robot may, is an end of it.
    """
    if column not in ranges:
        return -FIRST_NOISE.farthest_number, FIRST_NOISE.farthest_number
    low, high = min(ranges[column].low, base), max(ranges[column].high, base)
    return math.log(low / base) if low > 0.0 else -FIRST_NOISE.farthest_number, math.log(high / base)


def _prior(column: str, ranges: Ranges) -> float:
    """Prior standard deviation of the logarithm of a number: a quarter of the range that the platform's file gives.

    The usual prior of RECALIBRATION is the least, and stands where the file gives no range.
    """
    wanted = {"thrust_gain": ".maximum", "yaw_torque_gain": ".maximum"}.get(column, column)
    found = [each for key, each in ranges.items() if key.endswith(wanted) and each.low > 0.0]
    widths = [math.log(each.high / each.low) / RECALIBRATION.range_widths for each in found]
    return max([RECALIBRATION.prior, *widths])


def _stated(column: str, intervals: Ranges) -> float:
    """Standard deviation of the logarithm of a number by the 95 % interval that the platform's file gives, else 0."""
    given = intervals.get(column)
    return log_deviation(given.low, given.high) if given is not None and given.low > 0.0 else 0.0


def noise_unknowns(tracks: Sequence[Track], rows: Floats) -> list[Unknown]:
    """Unknowns of the noise: random forces and the noise of readings, fitted as logarithms around those in `rows`.

    Each robot has its own strength of random forces: the same water moves a robot of another mass or inertia otherwise,
    and forces are known relative to mass and inertia alone. Correlation time and smoothness are shared by all robots.
    Instruments on board have one noise in all recordings of a robot; poses, which a tracker outside sees, have one for
    each recording.
    """
    robots = tracks_by_robot(tracks)
    everybody = {tuple(robots): tuple(range(len(tracks)))}
    alone = {(robot,): numbers for robot, numbers in robots.items()}
    found = [
        Unknown(
            _noise_owner(RANDOM_FORCE, names, column),
            column,
            alike,
            _at(rows, alike, column),
            prior=prior.spread,
            bounds=prior.bounds,
        )
        for column, prior in WATER_PRIOR.items()
        for names, alike in (everybody if column in SHARED_NOISE else alone).items()
    ]
    for robot, numbers in robots.items():
        for column in _readings_of(tracks, numbers):
            owner = _noise_owner(READING, (robot,), column)
            for alike in [(number,) for number in numbers] if column.startswith("reading.pose") else [numbers]:
                base = _at(rows, alike, column)
                least = max(-FIRST_NOISE.finer_reading, math.log(LEAST_READING_NOISE[column]) - base)
                ends = (least, FIRST_NOISE.coarser_reading)
                found.append(Unknown(owner, column, alike, base, prior=FIRST_NOISE.reading_prior, bounds=ends))
    return found


def _noise_owner(effect: str, robots: tuple[str, ...], column: str) -> Owner:
    return Owner(effect, robots, column.partition(".")[2], NOISE_UNITS[column])


def _at(rows: Floats, tracks: Sequence[int], column: str) -> float:
    """Value in a column of `rows` (tracks, columns), of the first of the given tracks."""
    return float(rows[tracks[0], COLUMN[column]])


def _readings_of(tracks: Sequence[Track], numbers: Sequence[int]) -> list[str]:
    """Noise columns of the kinds of readings that the given tracks have."""
    kinds = np.unique(np.concatenate([tracks[number].timeline.kind for number in numbers]))
    present = {f"reading.{READING_NOISE_OF_KIND[kind]}" for kind in kinds}
    return [column for column in READING_NOISE if column in present]
