"""The platform's own numbers fitted together with the random forces of the water: the honest base of all comparisons.

Mass is not fitted: forces, drag and inertia are known relative to it alone. Which numbers can move is a table.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import RANDOM_FORCE, RECALIBRATION
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RobotLog
from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, make_fit, settled, with_noise
from cocorosim_ros.diagnosis.fitting.leaps import leapt
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import (
    COLUMN,
    NEUTRAL,
    PHYSICS,
    READING_COLUMNS,
    READING_NOISE,
    READING_NOISE_OF_KIND,
    WATER_NOISE,
)
from cocorosim_ros.diagnosis.tracks.surroundings import introduce
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import ARM, full_forces
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.reading.ranges import Ranges

# Columns, by the name that the contract reports, and their unit.
RECALIBRATED: dict[str, tuple[str, str]] = {
    "thrust_gain": ("thrust_gain", "1"),
    "yaw_torque_gain": ("yaw_torque_gain", "1"),
    "drag": ("drag", "kg/m"),
    "yaw_drag": ("yaw_drag", "N m s^2"),
    "yaw_inertia": ("inertia", "kg m^2"),
    "buoyancy_gain": ("buoyancy_gain", "1"),
}
MOST_DOUBLINGS = 12
MOST_ROUNDS = 10  # of a fit that a good start ends after two or three
FIRST_DISTURBANCE = 0.01  # of full thrust
FIRST_CORRELATION = 2.5  # s
FIRST_SMOOTHNESS = 0.4
# Of the logarithms: standard deviation and bounds, both from where the fit begins.
WATER_PRIOR: dict[str, tuple[float, tuple[float, float]]] = {
    "random.force": (3.0, (-7.0, 7.0)),
    "random.heave_force": (3.0, (-7.0, 7.0)),
    "random.moment": (3.0, (-7.0, 7.0)),
    "random.correlation": (0.7, (-7.0, math.log(RANDOM_FORCE.most_correlation / FIRST_CORRELATION))),
    "random.smoothness": (
        1.0,
        (math.log(RANDOM_FORCE.least_smoothness / FIRST_SMOOTHNESS), -math.log(FIRST_SMOOTHNESS)),
    ),
}
SHARED_NOISE = ("random.correlation", "random.smoothness")
# What the filter's steps are off by at least, however exact a reading is: m, m, rad, rad, Pa, rad/s, m/s^2, m/s.
LEAST_READING_NOISE = {
    "reading.pose_xy": 1e-4, "reading.pose_z": 1e-4, "reading.pose_yaw": 1e-3, "reading.compass": 1e-3,
    "reading.pressure": 1.0, "reading.gyro_z": 1e-3, "reading.accel": 1e-3, "reading.velocity": 1e-4,
}  # fmt: skip
INERTIAL = ("reading.gyro_z", "reading.accel")
# By how much the logarithms move for the further starts.
AT_RANDOM = {
    "random.force": math.log(10.0),
    "random.heave_force": math.log(10.0),
    "random.moment": math.log(10.0),
    "random.correlation": -math.log(10.0),
}


def make_tracks(evidence: Evidence) -> tuple[Track, ...]:
    """A track for every robot in every recording that has readings."""
    tracks = []
    for recording in evidence.recordings:
        fellows = [Track(evidence.platform, recording, log, _span(log)) for log in recording.robots if _times(log)]
        introduce(fellows)
        tracks += fellows
    return tuple(tracks)


def _times(log: RobotLog) -> list[Floats]:
    return [stream.time for stream in log.streams.values() if len(stream.time)]


def _span(log: RobotLog) -> tuple[float, float]:
    """From the first reading to the last [s]."""
    times = _times(log)
    return min(float(time[0]) for time in times), max(float(time[-1]) for time in times)


def base_rows(tracks: Sequence[Track]) -> Floats:
    """(tracks, columns) the platform's numbers, nothing out of the ordinary, noise as it is estimated at first."""
    rows = np.tile(NEUTRAL, (len(tracks), 1))
    for row, track in zip(rows, tracks, strict=True):
        row[PHYSICS] = track.platform_row
        for known, value in track.known.items():
            row[COLUMN[known]] = value
        full = full_forces(track)
        row[COLUMN["random.force"]] = math.log(FIRST_DISTURBANCE * full.across)
        row[COLUMN["random.heave_force"]] = math.log(FIRST_DISTURBANCE * full.random_heave)
        row[COLUMN["random.moment"]] = math.log(FIRST_DISTURBANCE * max(full.yaw, ARM * full.across))
        row[COLUMN["random.correlation"]] = math.log(FIRST_CORRELATION)
        row[COLUMN["random.smoothness"]] = math.log(FIRST_SMOOTHNESS)
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


def base_laws(tracks: Sequence[Track]) -> list[Unknown]:
    """The numbers of each robot's platform that may move."""
    laws = []
    for numbers in tracks_by_robot(tracks).values():
        ranges = tracks[numbers[0]].ranges
        for column in RECALIBRATED:
            base = float(tracks[numbers[0]].platform_row[COLUMN[column]])
            # Moments are known relative to the inertia alone, as forces are to the mass: it stays unless it is unknown.
            if base > 0.0 and (column != "yaw_inertia" or column in ranges):
                prior = _prior(column, ranges)
                laws.append(Unknown(column, numbers, base, logarithmic=True, prior=prior, bounds=(-4.0, 4.0)))
    return laws


def _prior(column: str, ranges: Ranges) -> float:
    """Standard deviation of the logarithm: a quarter of the platform's range, where it gives one."""
    wanted = {"thrust_gain": ".maximum", "yaw_torque_gain": ".maximum"}.get(column, column)
    found = [part for key, part in ranges.items() if key.endswith(wanted) and part.low > 0.0]
    widths = [math.log(part.high / part.low) / 4.0 for part in found]
    return max([RECALIBRATION.prior, *widths])


def noise_unknowns(tracks: Sequence[Track], rows: Floats) -> list[Unknown]:
    """Random forces and noise of readings, each robot's own; how fast the water changes is shared by all.

    The same water moves a robot of another mass or inertia otherwise, and forces are known relative to these alone. A
    robot's own instruments are the same in every recording; how well a tracker sees it is not.
    """
    robots = tuple(tracks_by_robot(tracks).values())
    everybody = (tuple(range(len(tracks))),)
    found = [
        Unknown(name, alike, float(rows[alike[0], COLUMN[name]]), prior=prior, bounds=bounds)
        for name, (prior, bounds) in WATER_PRIOR.items()
        for alike in (everybody if name in SHARED_NOISE else robots)
    ]
    for numbers in robots:
        present = {
            READING_NOISE_OF_KIND[kind] for number in numbers for kind in np.unique(tracks[number].readings.kind)
        }
        for column in READING_NOISE:
            if column.partition(".")[2] not in present:
                continue
            for alike in [(number,) for number in numbers] if column.startswith("reading.pose") else [numbers]:
                base = float(rows[alike[0], COLUMN[column]])
                least = max(-3.0, math.log(LEAST_READING_NOISE[column]) - base)
                found.append(Unknown(column, alike, base, prior=0.7, bounds=(least, 5.0)))
    return found


def first_fit(evidence: Evidence) -> Fit:
    """The model as the platform's file and the first guess of the noise have it."""
    tracks = make_tracks(evidence)
    rows = base_rows(tracks)
    return make_fit(tracks, rows, base_laws(tracks), noise_unknowns(tracks, rows))


def base_fit(evidence: Evidence) -> Fit:
    """The recalibrated model: the platform's numbers and the noise at their most likely values.

    Where the first guess of the noise shuts out readings, much is wrong, and the way from there may end anywhere: then
    a second way begins where hardly anything but chance moves the robot, and a third where its inertial sensors, which
    the model leans on at every step, are doubted before those that see where it is. From the best of them it leaps on.
    """
    first = first_fit(evidence)
    if not any(_is_shut(first, unknown) for unknown in first.noise):
        return settled(first, MOST_ROUNDS)
    starts = [first, _at_random(first)]
    if any(unknown.column in INERTIAL for unknown in first.noise):
        starts.append(_without_inertial(first))
    ways = [settled(_opened(start), MOST_ROUNDS) for start in starts]
    return leapt(max(ways, key=lambda fit: fit.objective), MOST_ROUNDS)


def _at_random(fit: Fit) -> Fit:
    """The fit with strong and quick random forces, and coarse readings: each is then heeded a little."""
    coarse = [RECALIBRATION.coarse if _is_shut(fit, unknown) else 0.0 for unknown in fit.noise]
    moves = np.array([AT_RANDOM.get(part.column, other) for part, other in zip(fit.noise, coarse, strict=True)])
    return _with_moved_noise(fit, moves)


def _without_inertial(fit: Fit) -> Fit:
    """The fit with inertial readings so coarse that they hardly count."""
    return _with_moved_noise(
        fit, np.array([RECALIBRATION.doubt if part.column in INERTIAL else 0.0 for part in fit.noise])
    )


def _with_moved_noise(fit: Fit, moves: Floats) -> Fit:
    return evaluated(replace(fit, q_noise=fit.q_noise + moves))


def _opened(fit: Fit) -> Fit:
    """The fit with the noise of those readings raised that are mostly beyond belief, lest nothing be learnt from them.

    A sensor that is off by many times its noise is no outlier; its effect takes the noise back.
    """
    for _ in range(MOST_DOUBLINGS):
        shut = [_is_shut(fit, unknown) for unknown in fit.noise]
        if not any(shut):
            return fit
        fit = _with_moved_noise(fit, math.log(2.0) * np.array(shut))
    return fit


def _is_shut(fit: Fit, noise: Unknown) -> bool:
    """Whether many of the readings of which this is the noise are not believed."""
    kinds = np.flatnonzero(COLUMN[noise.column] == READING_COLUMNS)
    for number in noise.tracks:
        chosen = np.isin(fit.tracks[number].readings.kind, kinds)
        if chosen.any() and np.mean(fit.passes[number].believed[chosen]) < 1.0 - RECALIBRATION.shut:
            return True
    return False


def nominal_fit(base: Fit) -> Fit:
    """The platform as its file has it, with the random forces that it then needs."""
    start = evaluated(replace(base, q=np.zeros(len(base.laws))))
    return with_noise(start, 3, WATER_NOISE)
