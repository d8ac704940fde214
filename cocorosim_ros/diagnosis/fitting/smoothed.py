"""Smoothed courses of the tracks of a fit."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.foundation.arrays import Floats


def smoothed_under(tracks: Sequence[Track], rows: Floats) -> tuple[Smoothed, ...]:
    """Smooth every track under its row of numbers (tracks, columns): its most likely course, in the order of tracks."""
    return tuple(of_each_track(lambda number: tracks[number].filter.smoothed(rows[number]), len(tracks)))


def smoothed_tracks(fit: Fit) -> tuple[Smoothed, ...]:
    """Smooth every track under the numbers of a fit."""
    return smoothed_under(fit.tracks, fit.filled)
