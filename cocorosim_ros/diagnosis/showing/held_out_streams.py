"""Errors of expected readings of streams that free runs do not cover, on the last part of each recording."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.showing.bootstrap import drawn, interval_of_root
from cocorosim_ros.diagnosis.showing.residual_reading import KIND_OF_TOPIC, deviation, unit_of_kind
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats

TOPICS = ("compass", "pressure", "imu")
"""Streams that are not a channel of the free runs."""


class HeldOutPart(NamedTuple):
    """Part of each recording that is held out."""

    seen: float  # share of the recording, from its beginning, that the fits saw
    stretch: float  # length [s] of stretches of which the errors count as independent, for intervals


def held_out_streams(
    tracks: Sequence[Track],
    courses: Sequence[Smoothed],
    models: Mapping[str, Floats],
    part: HeldOutPart,
) -> dict[str, HeldOut]:
    """Root mean squares of the deviations on the smoothed courses, by topic and model, after the part that fits saw.

    courses: the smoothed course of each track; models: rows (tracks, columns) of 'nominal', 'recalibrated' and
    'augmented'.
    """
    table = {}
    for topic in TOPICS:
        kind = KIND_OF_TOPIC[topic]
        seen = [number for number, track in enumerate(tracks) if np.any(track.timeline.kind == kind)]
        means = {
            name: [
                mean
                for number in seen
                for mean in _stretches(tracks[number], courses[number], rows[number], topic, part)
            ]
            for name, rows in models.items()
        }
        if not seen or not means["nominal"]:
            continue
        floor = math.sqrt(np.mean([_noise(tracks[number], topic) for number in seen]))
        values = {name: math.sqrt(np.mean(squared)) for name, squared in means.items()}
        intervals = {name: _interval(np.array(squared)) for name, squared in means.items()}
        table[topic] = HeldOut(**values, noise_floor=floor, unit=unit_of_kind(kind), intervals=intervals)
    return table


def _noise(track: Track, topic: str) -> float:
    """Variance of a stream's readings as averaged for the filter, by the noise that the stream's differences show."""
    share = track.timeline.share[track.timeline.kind == KIND_OF_TOPIC[topic]]
    return float(track.log.streams[topic].noise[0] ** 2 * share.mean())


def _stretches(track: Track, course: Smoothed, row: Floats, topic: str, part: HeldOutPart) -> list[float]:
    """Mean squared deviation of each stretch after the part that the fits saw."""
    chosen = track.timeline.kind == KIND_OF_TOPIC[topic]
    stamp = track.timeline.stamp[chosen]
    squared = deviation(track, chosen, course, row) ** 2
    begin = course.time[0] + part.seen * (course.time[-1] - course.time[0])
    number = np.floor((stamp - begin) / part.stretch).astype(int)
    return [float(squared[number == each].mean()) for each in np.unique(number[number >= 0])]


def _interval(squared: Floats) -> tuple[float, float]:
    return interval_of_root(squared, drawn(np.random.default_rng(0), len(squared)))
