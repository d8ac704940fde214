"""Delays that are looked for as differences: none below a step of the filter, and as long as a few readings take."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.criteria.against import CHANGES
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import slowness


def with_delays(entries: Sequence[Entry], tracks: Sequence[Track]) -> list[Entry]:
    """Copy entries, those of delays and lags with what is believed and looked for in the recordings of some tracks.

    Less than a step of the filter is not believed: it follows from how readings fall on grid points; halves of sound
    recordings had some. Errors of stamps are looked for up to several readings: a log that is read once a second is
    late by seconds, where one of twenty readings a second is late by a tenth.
    """
    slow = slowness(tracks[0].vehicle)  # by which a candidate multiplies all its delays
    step = max(track.timeline.grid.step for track in tracks) / slow
    return [_with_delay(entry, step, tracks, slow) for entry in entries]


def _with_delay(entry: Entry, step: float, tracks: Sequence[Track], slow: float) -> Entry:
    if not any(amplitude.searched for amplitude in entry.amplitudes):
        return entry
    late = CHANGES.late_readings * _slowest_gap(entry, tracks) / slow
    believed = (replace(each, negligible=(-step, step)) for each in entry.amplitudes)
    return replace(entry, amplitudes=tuple(_as_long_as(late, each) for each in believed))


def _as_long_as(late: float, amplitude: Amplitude) -> Amplitude:
    """Copy a delay, large in a bad case from `late` [s] on, with starts there beside those that it had."""
    if late <= amplitude.large:
        return amplitude
    own = (start * amplitude.large / late for start in amplitude.searched)
    return replace(amplitude, large=late, searched=tuple(sorted({*own, *amplitude.searched})))


def _slowest_gap(entry: Entry, tracks: Sequence[Track]) -> float:
    """Median time [s] between readings of the stream of an entry, the longest of all tracks; 0 without a stream."""
    if entry.topic is None:
        return 0.0
    streams = [track.log.streams[entry.topic] for track in tracks if entry.topic in track.log.streams]
    return max((float(np.median(np.diff(each.time))) for each in streams if len(each.time) > 1), default=0.0)
