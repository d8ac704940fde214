"""What the streams that something was found of show less what the model expects, before and after."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import COMPASS, GYRO, POSE_X, PRESSURE
from cocorosim_ros.diagnosis.findings import FoundEffect, ResidualReading
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE, SURFACE_PRESSURE

KIND_OF_TOPIC = {"pose": POSE_X, "compass": COMPASS, "pressure": PRESSURE, "imu": GYRO}
TOPIC_OF_EFFECT = {
    "compass_distortion": "compass", "pressure_offset": "pressure", "pressure_drift": "pressure", "imu_bias": "imu",
    "camera_scale": "pose",
}  # fmt: skip
UNITS = {POSE_X: "m", COMPASS: "rad", PRESSURE: "Pa", GYRO: "rad/s"}
# A late stream is off by its rate of change times the delay, a wrong clock ever more as time goes on.
RATE_OF_TOPIC = {"pose": "u", "compass": "r", "pressure": "w", "imu": "t"}
REGRESSOR_OF_EFFECT = {"compass_distortion": "yaw", "camera_scale": "x"}
STATE_COLUMNS = {"x": 0, "y": 1, "z": 2, "yaw": 3, "u": 4, "v": 5, "w": 6, "r": 7}


def residual_readings(
    base: Fit, final: Fit, courses: tuple[Sequence[Smoothed], Sequence[Smoothed]], effects: Sequence[FoundEffect]
) -> tuple[ResidualReading, ...]:
    """For every stream that one of the effects is of; courses: the most likely ones of `base` and of `final`."""
    found = []
    for effect in effects:
        topic = effect.topic or TOPIC_OF_EFFECT.get(effect.id)
        if effect.correction is not None or topic not in KIND_OF_TOPIC:
            continue
        regressor = _regressor(effect, topic)
        for number, track in enumerate(base.tracks):
            chosen = track.timeline.kind == KIND_OF_TOPIC[topic]
            if track.name not in effect.robots or not chosen.any():
                continue
            rows = base.filled[number], final.filled[number]
            before, after = (
                deviation(track, chosen, course[number], row) for course, row in zip(courses, rows, strict=True)
            )
            stamp = track.timeline.stamp[chosen]
            against = _along(regressor, stamp, courses[1][number])
            unit = UNITS[KIND_OF_TOPIC[topic]]
            found.append(ResidualReading(track.name, topic, unit, regressor, stamp, against, before, after))
    return tuple(found)


def _regressor(effect: FoundEffect, topic: str) -> str:
    if effect.id == "sensor_latency":
        return RATE_OF_TOPIC[topic]
    first = effect.id.partition("~")[2].strip("|").partition("|")[0].partition("*")[0]
    return REGRESSOR_OF_EFFECT.get(effect.id, first if first in STATE_COLUMNS else "t")


def _along(regressor: str, stamp: Floats, course: Smoothed) -> Floats:
    if regressor == "t":
        return stamp
    values = np.interp(stamp, course.time, course.mean[:, STATE_COLUMNS[regressor]])
    return np.mod(values + np.pi, 2.0 * np.pi) - np.pi if regressor == "yaw" else values


def deviation(track: Track, chosen: Flags, course: Smoothed, row: Floats) -> Floats:
    """Readings less what sensors with these numbers show on this course."""
    kind = int(track.timeline.kind[chosen][0])
    topic = next(name for name, each in KIND_OF_TOPIC.items() if each == kind)
    stamp = track.timeline.stamp[chosen]
    moment = (stamp - row[COLUMN[f"sensor_latency.{topic}"]]) / (1.0 + row[COLUMN[f"clock_skew.{topic}"]])
    state = np.array([np.interp(moment, course.time, column) for column in course.mean.T]).T
    deviation = track.timeline.value[chosen] - track.filter.law_shift(row)[chosen] - _shown(kind, state, stamp, row)
    return np.mod(deviation + np.pi, 2.0 * np.pi) - np.pi if kind == COMPASS else deviation


def _shown(kind: int, state: Floats, stamp: Floats, row: Floats) -> Floats:
    """What a sensor with these numbers shows in these states (n, 8)."""
    if kind == COMPASS:
        yaw = state[:, 3]
        offset, sine, cosine = (row[COLUMN[f"compass_distortion.{name}"]] for name in ("offset", "sin", "cos"))
        return np.asarray(yaw + offset + sine * np.sin(yaw) + cosine * np.cos(yaw))
    if kind == PRESSURE:
        error = row[COLUMN["pressure_offset.offset"]] + row[COLUMN["pressure_drift.rate"]] * stamp
        return np.asarray(SURFACE_PRESSURE - PASCAL_PER_METRE * state[:, 2] + error)
    if kind == GYRO:
        return np.asarray(state[:, 7] + row[COLUMN["imu_bias.gyro_z"]])
    return np.asarray(state[:, 0] * row[COLUMN["camera_scale.scale"]])
