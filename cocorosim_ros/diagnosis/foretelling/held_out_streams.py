"""Errors of expected readings of streams that free runs do not cover, in the held-out parts of each recording.

A stream is measured where other readings show the same state, on the course that the recalibrated model's smoother sees
in those others alone: on a course that has followed the stream itself, its errors would seem smaller than they are, and
the law that is right would seem wrong. So a stream whose stamps a model changes has no part in its course either: a
gyroscope whose clock runs wrong makes the turns of a course come at wrong times.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.bootstrap import drawn, interval_of_root
from cocorosim_ros.diagnosis.foretelling.deviation import KIND_OF_TOPIC, deviation, unit_of_kind
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.sensors.pose import POSE
from cocorosim_ros.world.sensors.pressure import PRESSURE
from cocorosim_ros.world.state.state import YAW, YAW_RATE, Z


class Stream(NamedTuple):
    """A stream that is not a channel of the free runs."""

    shown_by: tuple[str, ...]  # kinds of other readings, of which one at least has to be there; () for any
    hidden: bool  # whether the course is made without the stream
    column: int  # of the state that it shows
    factor: float  # of the reading by that state, 0 for one that no single state shows; of a pressure per water_weight


BY_PLACES = ("pose_x",)  # kind of reading that shows speeds too, of streams that any other may show

COMPARED_STREAMS: Mapping[str, Stream] = {
    **dict.fromkeys((topic for topic in KIND_OF_TOPIC if topic != POSE.topic), Stream((), False, Z, 0.0)),
    "compass": Stream(("pose_yaw",), True, YAW, 1.0),
    PRESSURE.topic: Stream(("pose_z",), True, Z, 1.0),
    # A rate that errs leads the course astray by its integral, which the heading does not allow.
    "imu": Stream(("pose_yaw", "compass"), False, YAW_RATE, 1.0),
}


class HeldOutPart(NamedTuple):
    """Parts of each recording that are held out."""

    spans: Sequence[Sequence[tuple[float, float]]]  # by track: begin and end of each [s]
    stretch: float  # length [s] of stretches of which the errors count as independent, for intervals


class HeldOutStretches(NamedTuple):
    """Parts of one recording that are held out, cut into stretches."""

    spans: Sequence[tuple[float, float]]  # begin and end of each part [s]
    length: float  # of a stretch [s]


def held_out_streams(
    tracks: Sequence[Track], plain: Floats, models: Mapping[str, Floats], part: HeldOutPart
) -> dict[str, HeldOut]:
    """Root mean squares of the deviations in the held-out parts, by topic and model.

    plain: rows (tracks, columns) of the recalibrated model, by which the courses are made; models: rows of 'nominal',
    'recalibrated' and 'augmented'. The noise floor is the error of the readings and that of the course.
    """
    table = {}
    for topic, stream in COMPARED_STREAMS.items():
        kind = KIND_OF_TOPIC[topic]
        seen = [
            number
            for number, track in enumerate(tracks)
            if np.any(track.timeline.kind == kind) and _is_shown(track, stream) and part.spans[number]
        ]
        retimed = _is_retimed(topic, plain, models)
        courses = {number: _course(tracks[number], plain[number], topic, retimed=retimed) for number in seen}
        means = {
            name: np.concatenate(
                [
                    _stretches(
                        tracks[number],
                        courses[number],
                        rows[number],
                        topic,
                        HeldOutStretches(part.spans[number], part.stretch),
                    )
                    for number in seen
                ]
            )
            for name, rows in models.items()
            if seen
        }
        if not seen or not len(means["nominal"]):
            continue
        floor = math.sqrt(np.mean([_noise(tracks[number], topic, courses[number]) for number in seen]))
        values = {name: math.sqrt(np.mean(squared)) for name, squared in means.items()}
        intervals = {name: _interval(squared) for name, squared in means.items()}
        unit = unit_of_kind(kind)
        table[topic] = HeldOut(**values, noise_floor=floor, unit=unit, intervals=intervals, against="course")
    return table


def _is_shown(track: Track, stream: Stream) -> bool:
    return not stream.shown_by or track.timeline.sees(*stream.shown_by)


def _is_retimed(topic: str, plain: Floats, models: Mapping[str, Floats]) -> bool:
    """Tell whether any model has other stamps of a topic than the model that makes the courses."""
    columns = [COLUMN[f"{error}.{topic}"] for error in ("sensor_latency", "clock_skew")]
    return any(not np.array_equal(rows[:, columns], plain[:, columns]) for rows in models.values())


def _course(track: Track, row: Floats, topic: str, *, retimed: bool) -> Smoothed:
    """The recalibrated model's course, seen without the stream where that would lead it astray.

    retimed: whether the models differ in the stream's stamps. Then it is left out where others show the same.
    """
    stream = COMPARED_STREAMS[topic]
    hidden = stream.hidden or (retimed and track.timeline.sees(*(stream.shown_by or BY_PLACES)))
    return (track.without_stream(topic) if hidden else track).filter.smoothed(row)


def _noise(track: Track, topic: str, course: Smoothed) -> float:
    """Variance of a stream's averaged readings, by the noise that its differences show, and that of the course."""
    share = track.timeline.share[track.timeline.kind == KIND_OF_TOPIC[topic]]
    stream = COMPARED_STREAMS[topic]
    weight = track.vehicle.water_weight if topic == PRESSURE.topic else 1.0
    spread = stream.factor * weight * course.spread[:, stream.column]
    return float(track.log.streams[topic].noise[0] ** 2 * share.mean() + np.mean(spread**2))


def _stretches(track: Track, course: Smoothed, row: Floats, topic: str, held: HeldOutStretches) -> Floats:
    """Mean squared deviations (n,) of the stretches of a track's held-out parts."""
    chosen = track.timeline.kind == KIND_OF_TOPIC[topic]
    stamp = track.timeline.stamp[chosen]
    squared = deviation(track, chosen, course, row) ** 2
    return np.array(
        [
            squared[inside].mean()
            for begin, end in held.spans
            for inside in _in_stretches(stamp, begin, end, held.length)
        ]
    )


def _in_stretches(stamp: Floats, begin: float, end: float, length: float) -> list[Flags]:
    """Flags (n,) of the stamps in each stretch of so many seconds between `begin` and `end` [s] that has any."""
    edges = np.arange(begin, end, length)
    found = [(stamp >= edge) & (stamp < min(edge + length, end)) for edge in edges]
    return [inside for inside in found if inside.any()]


def _interval(squared: Floats) -> tuple[float, float]:
    return interval_of_root(squared, drawn(np.random.default_rng(0), len(squared)))
