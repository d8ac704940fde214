"""Smoothed courses of the tracks of a fit."""

from __future__ import annotations

from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track


def smoothed_tracks(fit: Fit) -> tuple[Smoothed, ...]:
    """Smooth every track under the numbers of a fit: its most likely course, in the order of the tracks."""
    filled = fit.filled
    return tuple(of_each_track(lambda number: fit.tracks[number].filter.smoothed(filled[number]), len(fit.tracks)))
