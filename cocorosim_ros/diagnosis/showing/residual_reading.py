"""What the streams that something was found of show less what the model expects, before and after."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import ANGLES, KIND_NAMES
from cocorosim_ros.diagnosis.filter.reading import expected_along
from cocorosim_ros.diagnosis.findings import FoundEffect, ResidualReading
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.columns import SENSORS as SENSORS_IN_ROW
from cocorosim_ros.diagnosis.tracks.track import Smoothed, Track
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.sensors import KINDS, SENSORS
from cocorosim_ros.world.sensors.errors import ERRORS

_RECORDED = {topic: sensor.recorded for topic, sensor in SENSORS.items() if sensor.recorded and sensor.recorded.drawn}
KIND_OF_TOPIC = {topic: KIND_NAMES.index(recorded.drawn) for topic, recorded in _RECORDED.items()}
"""The number of each stream that is drawn."""
UNITS = {code: KINDS[KIND_NAMES[code]].unit for code in KIND_OF_TOPIC.values()}
STATE_COLUMNS = {"x": 0, "y": 1, "z": 2, "yaw": 3, "u": 4, "v": 5, "w": 6, "r": 7}


def residual_readings(
    base: Fit, final: Fit, courses: tuple[Sequence[Smoothed], Sequence[Smoothed]], effects: Sequence[FoundEffect]
) -> tuple[ResidualReading, ...]:
    """For every stream that one of the effects is of; courses: the most likely ones of `base` and of `final`."""
    found = []
    for effect in effects:
        topic = effect.topic or (ERRORS[effect.id].sensor if effect.id in ERRORS else None)
        if effect.correction is not None or topic not in KIND_OF_TOPIC:
            continue
        regressor = _regressor(effect, topic)
        for number, track in enumerate(base.tracks):
            chosen = track.readings.kind == KIND_OF_TOPIC[topic]
            if track.name not in effect.robots or not chosen.any():
                continue
            rows = base.filled[number], final.filled[number]
            before, after = (
                deviation(track, chosen, course[number], row) for course, row in zip(courses, rows, strict=True)
            )
            stamp = track.readings.stamp[chosen]
            against = _along(regressor, stamp, courses[1][number])
            unit = UNITS[KIND_OF_TOPIC[topic]]
            found.append(ResidualReading(track.name, topic, unit, regressor, stamp, against, before, after))
    return tuple(found)


def _regressor(effect: FoundEffect, topic: str) -> str:
    if effect.id == "sensor_latency":
        # A late stream is off by its rate of change times the delay, a wrong clock ever more as time goes on.
        return _RECORDED[topic].late_with
    if effect.id in ERRORS:
        return ERRORS[effect.id].against
    first = effect.id.partition("~")[2].strip("|").partition("|")[0].partition("*")[0]
    return first if first in STATE_COLUMNS else "t"


def _along(regressor: str, stamp: Floats, course: Smoothed) -> Floats:
    if regressor == "t":
        return stamp
    values = np.interp(stamp, course.time, course.mean[:, STATE_COLUMNS[regressor]])
    return np.mod(values + np.pi, 2.0 * np.pi) - np.pi if regressor == "yaw" else values


def deviation(track: Track, chosen: Flags, course: Smoothed, row: Floats) -> Floats:
    """Readings less what sensors with these numbers show on this course."""
    kind = int(track.readings.kind[chosen][0])
    topic = next(name for name, each in KIND_OF_TOPIC.items() if each == kind)
    stamp = track.readings.stamp[chosen]
    moment = (stamp - row[COLUMN[f"sensor_latency.{topic}"]]) / (1.0 + row[COLUMN[f"clock_skew.{topic}"]])
    state = np.array([np.interp(moment, course.time, column) for column in course.mean.T]).T
    deviation = track.readings.value[chosen] - track.law_shift(row)[chosen] - _shown(kind, state, stamp, row)
    return np.mod(deviation + np.pi, 2.0 * np.pi) - np.pi if kind in ANGLES else deviation


def _shown(kind: int, state: Floats, stamp: Floats, row: Floats) -> Floats:
    """What a sensor with these numbers shows in these states (n, 8)."""
    shown = np.empty(len(stamp))
    expected_along(kind, state, stamp, row[SENSORS_IN_ROW], shown)
    return shown
