"""Differences that are one and the same to recordings of a single stream: commands that act late, and late readings.

Where all readings come from one stream, nothing else has its time: whether the commands act later by so much or the
readings are stamped later by so much, every reading comes as long after its command. So each is told as the other's
rival, however little the other's evidence was looked at.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from cocorosim_ros.diagnosis.against.numbers import DELAY
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, NearRival
from cocorosim_ros.diagnosis.tracks.lateness import clocks_of
from cocorosim_ros.diagnosis.tracks.track import Track

LATE_READINGS = "sensor_latency"
_TWINS = {DELAY: LATE_READINGS, LATE_READINGS: DELAY}


def with_twin(effect: NamedEffect, candidates: Sequence[Candidate], tracks: Sequence[Track]) -> NamedEffect:
    """Add the twin of a delay to its rivals, if its robots have one stream; tracks: by the candidates' numbers."""
    mine = effect.candidate
    twin = _TWINS.get(mine.entry.id)
    if twin is None or len(streams_of([tracks[number] for number in mine.everybody])) != 1:
        return effect
    found = [each for each in candidates if each.entry.id == twin and each.robots == mine.robots]
    others = tuple(rival for rival in effect.rivals if rival.candidate.entry.id != twin)
    return replace(effect, rivals=(*(NearRival(each, 0.0) for each in found[:1]), *others)) if found else effect


def streams_of(tracks: Sequence[Track]) -> set[str]:
    """Topics of which some of the tracks have readings."""
    return {topic for track in tracks for topic in clocks_of(track.log)}
