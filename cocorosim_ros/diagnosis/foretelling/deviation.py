"""Deviations of readings: what a stream read less what a model expects it to show on a course."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import ANGLES, KIND_NAMES, KINDS_OF_STREAM
from cocorosim_ros.diagnosis.filter.reading import expected_along
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.columns import SENSORS as SENSORS_IN_ROW
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.motion.dynamics import relative_velocity
from cocorosim_ros.world.sensors import KINDS, SENSORS

RECORDED = {topic: sensor.recorded for topic, sensor in SENSORS.items() if sensor.recorded and sensor.recorded.drawn}
KIND_OF_TOPIC = {topic: KIND_NAMES.index(recorded.drawn) for topic, recorded in RECORDED.items()}
"""Kind of reading, as its code, that is drawn for a stream; by topic."""


def unit_of_kind(kind: int) -> str:
    """The SI unit of a kind of reading."""
    return KINDS[KIND_NAMES[kind]].unit


def deviation(track: Track, chosen: Flags, course: Smoothed, row: Floats) -> Floats:
    """Deviations (n,) of readings of one kind: readings less expectations on a smoothed course, angles the shorter way.

    chosen (m,): flags of the readings in the track's timeline; row: the numbers of the model, sensors' errors and the
    errors of stamps among them.
    """
    kind = int(track.timeline.kind[chosen][0])
    topic = next(name for name, each in KINDS_OF_STREAM.items() if kind in each)
    stamp = track.timeline.stamp[chosen]
    moment = (stamp - row[COLUMN[f"sensor_latency.{topic}"]]) / (1.0 + row[COLUMN[f"clock_skew.{topic}"]])
    state = np.array([np.interp(moment, course.time, column) for column in course.mean.T]).T
    water = _through_water(track, kind, moment, state, row)
    shown = _shown(kind, state, water, stamp, row)
    deviation = track.timeline.value[chosen] - track.filter.law_shift(row)[chosen] - shown
    return np.mod(deviation + np.pi, 2.0 * np.pi) - np.pi if kind in ANGLES else deviation


def _through_water(track: Track, kind: int, moment: Floats, state: Floats, row: Floats) -> Floats:
    """Velocities through the water (n, 4) [m/s, rad/s; body] in states (n, 8 or more) at moments (n,) [s].

    Zero for kinds of readings that do not depend on them.
    """
    water = np.zeros((len(moment), 4))
    if KINDS[KIND_NAMES[kind]].of_water:
        body = track.actuation.vehicle.body(row)
        for time, each, relative in zip(moment, np.ascontiguousarray(state), water, strict=True):
            relative_velocity(each, time, body, relative)
    return water


def _shown(kind: int, state: Floats, water: Floats, stamp: Floats, row: Floats) -> Floats:
    """Readings (n,) of one kind that a sensor with the numbers in `row` shows in the states (n, 8 or more)."""
    shown = np.empty(len(stamp))
    expected_along(kind, state, water, stamp, row[SENSORS_IN_ROW], shown)
    return shown
