"""Rulers of free runs: the readings that show a channel, or the recalibrated model's course where none does."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES, WATER_WEIGHT
from cocorosim_ros.diagnosis.findings import Against
from cocorosim_ros.diagnosis.foretelling.deviation import deviation
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import YAW, X, Y, Z


class Channel(NamedTuple):
    """A part of the state whose error is told."""

    unit: str
    columns: tuple[int, ...]  # of the state
    shown_by: tuple[tuple[str, ...], ...]  # kinds of readings, the best choice first; each choice is taken as a whole
    moved_by: tuple[str, ...]  # kinds of readings that show its rate


_OVER_GROUND = ("ground_velocity_u", "ground_velocity_v", "ground_velocity_w")
CHANNELS: Mapping[str, Channel] = {
    "position": Channel("m", (X, Y), (("pose_x", "pose_y"),), ("velocity_u", "velocity_v", *_OVER_GROUND[:2])),
    "heading": Channel("rad", (YAW,), (("pose_yaw",), ("compass",)), ("gyro_z",)),
    "depth": Channel("m", (Z,), (("pose_z",), ("pressure",)), ("velocity_w", *_OVER_GROUND[2:])),
}
PER_UNIT = {"pressure": COLUMN[WATER_WEIGHT]}
"""Column of the amount of a reading by unit of its channel, of kinds for which these are not the same."""


def against(channel: str, tracks: Sequence[Track]) -> Against | None:
    """Tell what errors of a channel are measured against in these tracks; None if nothing shows it or its rate."""
    if any(_shown_by(channel, track) for track in tracks):
        return "readings"
    rates = CHANNELS[channel].moved_by
    return "course" if any(track.timeline.sees(rate) for track in tracks for rate in rates) else None


def _shown_by(channel: str, track: Track) -> tuple[str, ...]:
    """Kinds of readings that show a channel in a track, empty if none does."""
    choices = CHANNELS[channel].shown_by
    return next((kinds for kinds in choices if all(track.timeline.sees(kind) for kind in kinds)), ())


@dataclass(frozen=True)
class Errors:
    """Errors of a path through a window: moments (n,) [s] and errors (n, columns) by column of the channel's state."""

    time: Floats
    value: Floats

    @property
    def mean_square(self) -> float:
        """Mean of the squares over the moments, columns added; NaN without moments."""
        return float((self.value**2).sum(axis=1).mean()) if len(self.time) else float("nan")


def errors_of_readings(channel: str, track: Track, path: Smoothed, row: Floats, window: Span) -> Errors:
    """Readings of a window less what a sensor with the numbers in `row` shows on a path over the whole grid.

    The readings of the first grid point, where the path begins, do not count.
    """
    kinds = _shown_by(channel, track)
    timeline, step = track.timeline, track.timeline.grid.step
    begin, end = path.time[window.first] + 0.5 * step, path.time[window.end - 1] + 0.5 * step
    inside = (timeline.stamp > begin) & (timeline.stamp <= end)
    found = []
    for kind in kinds:
        chosen = inside & (timeline.kind == KIND_NAMES.index(kind))
        if not chosen.any():
            return NO_ERRORS
        amount = row[PER_UNIT[kind]] if kind in PER_UNIT else 1.0
        found.append((timeline.stamp[chosen], deviation(track, chosen, path, row) / amount))
    if not found:
        return NO_ERRORS
    time = found[0][0]
    for stamps, _ in found[1:]:
        time = np.intersect1d(time, stamps)
    return Errors(time, np.column_stack([error[np.isin(stamps, time)] for stamps, error in found]))


def errors_of_course(channel: str, path: Smoothed, course: Smoothed, window: Span) -> Errors:
    """Course of a window less the path, both over the whole grid; angles the shorter way.

    The path is laid so that it begins where the course does, and heads as the course does there: no reading shows that
    place, and a model that puts a compass right would be charged with the turned map of the one that did not.
    """
    columns, first = CHANNELS[channel].columns, window.first
    of_course, of_path = (
        each.mean[first + 1 : window.end, list(columns)] - each.mean[first, list(columns)] for each in (course, path)
    )
    if columns == (YAW,):
        off = np.mod(of_course - of_path + np.pi, 2.0 * np.pi) - np.pi
        return Errors(path.time[first + 1 : window.end], off)
    if columns == (X, Y):
        turned = course.mean[first, YAW] - path.mean[first, YAW]
        cos, sin = np.cos(turned), np.sin(turned)
        of_path = of_path @ np.array([[cos, sin], [-sin, cos]])
    return Errors(path.time[first + 1 : window.end], of_course - of_path)


NO_ERRORS = Errors(np.zeros(0), np.zeros((0, 1)))
