"""Search for readings that the most likely course leaves by more than their noise, however likely the course is."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.catalogue.law_words import READING_WORDS
from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES, KINDS_OF_STREAM
from cocorosim_ros.diagnosis.foretelling.deviation import deviation
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import MEMORY_COLUMNS, READING_COLUMNS, WHITE
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.units.quantity_text import plain_number, said_quantity
from cocorosim_ros.world.sensors import KINDS

_OF_RATES = ("accel_x", "accel_y", "accel_z")  # these need rates, which a smoothed course does not have


class Left(NamedTuple):
    """A kind of readings that a course leaves: by how much [its unit], and in multiples of its noise."""

    kind: str
    off: float
    ratio: float


def strayed_course(case: Case) -> Iterator[Objection]:
    """Object to most likely courses of a robot that leave the readings by more than their noise."""
    for robot, numbers in tracks_by_robot(case.final.tracks).items():
        left = readings_left(case, numbers)
        if left:
            yield _objection(robot, len(numbers), list(left.values()))


def strayed_mostly(case: Case) -> Iterator[Objection]:
    """Object to courses that leave the readings by more than their noise on most tracks of a robot."""
    for robot, numbers in tracks_by_robot(case.final.tracks).items():
        left = readings_left(case, numbers)
        if 2 * len(left) > len(numbers):
            yield _objection(robot, len(numbers), list(left.values()))


def readings_left(case: Case, numbers: Sequence[int]) -> Mapping[int, Sequence[Left]]:
    """Map numbers of tracks to readings that are left; only of tracks where there are any."""
    found = {k: list(_left(case.final.tracks[k], case.courses[k], case.final.filled[k])) for k in numbers}
    return {k: left for k, left in found.items() if left}


def _objection(robot: str, count: int, strayed: Sequence[Sequence[Left]]) -> Objection:
    """One objection for all recordings of a robot; count: of these; strayed: readings that are left, by recording."""
    some = "all" if len(strayed) == count else f"{len(strayed)} of"
    where = f", in {some} its {count} recordings" if count > 1 else ""
    most = ", at most" if len(strayed) > 1 else ""
    return Objection(
        f"The most likely course of {robot} leaves its readings by more than their noise{where}{most}: "
        f"{in_words(strayed)}.",
        (robot,),
    )


def in_words(strayed: Sequence[Sequence[Left]]) -> str:
    """Words for the readings that are left, of each kind by how far at most; strayed: by recording."""
    worst: dict[str, Left] = {}
    for each in (each for left in strayed for each in left):
        if each.kind not in worst or each.ratio > worst[each.kind].ratio:
            worst[each.kind] = each
    return "; ".join(_words(worst[kind]) for kind in KIND_NAMES if kind in worst)


def _words(left: Left) -> str:
    off = said_quantity(left.off, KINDS[left.kind].unit)
    return f"{READING_WORDS[left.kind]} by {off}, {plain_number(left.ratio)} times their noise"


def _left(track: Track, course: Smoothed, row: Floats) -> Iterator[Left]:
    """Kinds of readings that a course leaves, each with how far."""
    for kind, off in _distances(track, course, row):
        noise = _noise(track, kind, row)
        if off > HARD_STOPS.strayed * noise:
            yield Left(KIND_NAMES[kind], off, off / noise)


def distances(case: Case, numbers: Sequence[int]) -> Mapping[int, Sequence[Left]]:
    """Map numbers of tracks to how far a course is from each kind of readings, in multiples of their noise.

    A fit may take errors that last for noise, however large. Places may wander so, as those of satellites do; noise of
    all else is that from one reading to the next.
    """
    return {number: _from_each_kind(case, number) for number in numbers}


def _from_each_kind(case: Case, number: int) -> list[Left]:
    track, row = case.final.tracks[number], case.final.filled[number]
    found = _distances(track, case.courses[number], row)
    return [Left(KIND_NAMES[kind], off, off / _own_noise(track, kind, row)) for kind, off in found]


def _own_noise(track: Track, kind: int, row: Floats) -> float:
    return _noise(track, kind, row) if KINDS[KIND_NAMES[kind]].unit == "m" else _noise_of_one(track, kind)


def _distances(track: Track, course: Smoothed, row: Floats) -> Iterator[tuple[int, float]]:
    """Kinds of readings, by number, and how far most of them are from a course."""
    for kind in np.unique(track.timeline.kind).tolist():
        name = KIND_NAMES[kind]
        if name in _OF_RATES or KINDS[name].of_water:
            continue
        chosen = track.timeline.kind == kind
        yield kind, float(np.quantile(np.abs(deviation(track, chosen, course, row)), HARD_STOPS.most))


def _noise(track: Track, kind: int, row: Floats) -> float:
    """Noise of most readings of a kind, as averaged for the filter, and never less than the filter's steps err by.

    Of errors that last differences show a part alone; then it is no less than what the fit has, row (columns,).
    """
    single = _noise_of_one(track, kind)
    if not np.isfinite(single):
        return np.inf
    if row[MEMORY_COLUMNS[kind]] != WHITE:
        single = max(single, float(np.exp(row[READING_COLUMNS[kind]])))
    share = float(np.median(track.timeline.share[track.timeline.kind == kind]))
    return max(single * math.sqrt(share), KINDS[KIND_NAMES[kind]].least_noise)


def _noise_of_one(track: Track, kind: int) -> float:
    """Noise of single readings of a kind, by their differences, and never less than the filter's steps err by.

    Infinite where differences do not tell it.
    """
    topic = next(name for name, kinds in KINDS_OF_STREAM.items() if kind in kinds)
    single = float(track.log.streams[topic].noise[KINDS_OF_STREAM[topic].index(kind)])
    return max(single, KINDS[KIND_NAMES[kind]].least_noise) if np.isfinite(single) else math.inf
