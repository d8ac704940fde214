"""Predictions that err again and again to the same side, or much farther than the filter expects."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.catalogue.law_words import READING_WORDS
from cocorosim_ros.diagnosis.criteria.showing import HARD_STOPS
from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.showing.case import Case, Objection
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats


class Coloured(NamedTuple):
    """Readings whose predictions err not at random: kind, size over what the filter expects, correlation (0..1)."""

    kind: str
    scale: float
    related: float


def coloured_innovations(case: Case) -> Iterator[Objection]:
    """Object to robots whose readings are foretold not at random, each once, with the worst of its recordings.

    What errs by a small share of what the filter expects is not looked at, however regular it is.
    """
    for robot, numbers in tracks_by_robot(case.final.tracks).items():
        found = {
            number: list(_coloured([case.final.tracks[number]], [case.final.passes[number]])) for number in numbers
        }
        coloured = {number: kinds for number, kinds in found.items() if kinds}
        if coloured:
            yield Objection(_sentence(robot, [case.final.tracks[number] for number in numbers], coloured), (robot,))


def coloured_at_once(robot: str, tracks: Sequence[Track], passes: Sequence[Pass]) -> Iterator[Objection]:
    """Object to predictions of a robot that err not at random on some tracks together; passes: of each track."""
    found = list(_coloured(tracks, passes))
    if found:
        yield Objection(_sentence(robot, tracks[:1], {0: found}), (robot,))


def _sentence(robot: str, tracks: Sequence[Track], coloured: dict[int, list[Coloured]]) -> str:
    """tracks: all of the robot; coloured: readings by number of the track."""
    worst: dict[str, Coloured] = {}
    for each in (each for kinds in coloured.values() for each in kinds):
        if each.kind not in worst or each.scale > worst[each.kind].scale:
            worst[each.kind] = each
    told = "; ".join(_words(worst[kind]) for kind in KIND_NAMES if kind in worst)
    where = f", in {len(coloured)} of its {len(tracks)} recordings" if len(tracks) > 1 else ""
    most = ", at most" if len(coloured) > 1 else ""
    return f"What the model foretells of {robot} errs not at random{where}{most}: {told}; something is still missing."


def _words(each: Coloured) -> str:
    words = f"{READING_WORDS[each.kind]} by {each.scale:.2g} times what the filter expects"
    if each.related > HARD_STOPS.correlated:
        words += f", mostly to the same side as just before (correlation {each.related:.2f})"
    return words


def _coloured(tracks: Sequence[Track], passes: Sequence[Pass]) -> Iterator[Coloured]:
    """Kinds of readings whose innovations, on some tracks together, are not white."""
    for kind in np.unique(np.concatenate([track.timeline.kind for track in tracks])).tolist():
        by_track = [_sizes(track, passed, kind) for track, passed in zip(tracks, passes, strict=True)]
        sizes = np.concatenate(by_track)
        if len(sizes) < HARD_STOPS.fewest:
            continue
        scale = float(np.sqrt(np.mean(sizes**2)))
        beside = np.concatenate([own[1:] * own[:-1] for own in by_track])
        related = float(np.mean(beside)) / scale**2 if scale > 0.0 else 0.0
        one_sided = related > HARD_STOPS.correlated and scale > HARD_STOPS.material
        if one_sided or scale > HARD_STOPS.scale:
            yield Coloured(KIND_NAMES[kind], scale, related)


def _sizes(track: Track, passed: Pass, kind: int) -> Floats:
    """Innovations (n,) of a kind that were believed, over their standard deviations."""
    chosen = (track.timeline.kind == kind) & passed.believed
    return np.asarray(passed.innovation[chosen] / np.sqrt(passed.variance[chosen]))
