"""Free runs through held-out parts of the recordings, by models fitted to the other parts alone, against readings.

Every model starts from one state: what the recalibrated model's filter had made of the readings up to that moment,
without later ones and without the named effects. (The errors of readings that count, `fixed_errors`, are taken off the
readings first.) From there it takes no readings and no random force, and is measured against the readings that come. A
smoothed course is no measure: it is bent by the model that made it. Where no reading shows a channel, the recalibrated
model's smoothed course stands in, which no named effect has bent.

The noise floor is the error, by the same measure, of a model that names nothing: the recalibrated one with a learnt
force (`nameless_force`). It holds the error of the readings, that of the start and what random force does; an augmented
model has no part in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUNS
from cocorosim_ros.diagnosis.findings import Against, FreeRun, HeldOut
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.foretelling.bootstrap import drawn, interval_of_root
from cocorosim_ros.diagnosis.foretelling.fixed_errors import with_fixed_errors
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span, Split, fitted_to_the_rest, split_tracks
from cocorosim_ros.diagnosis.foretelling.held_out_streams import HeldOutPart, held_out_streams
from cocorosim_ros.diagnosis.foretelling.horizon import coasting_time, window_length
from cocorosim_ros.diagnosis.foretelling.nameless_force import explained_forces
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS, Errors, against, errors_of_course, errors_of_readings
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.track_filter import NO_PUSH
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import STATE_SIZE, YAW, X, Y, Z

MODELS = ("nominal", "recalibrated", "augmented")
FLOOR = "noise_floor"
SHOWN = (X, Y, Z, YAW)  # columns of the state that a picture has


@dataclass(frozen=True)
class Unseen:
    """Measure of all models, made from the recalibrated fit alone; sequences are by track.

    rows (tracks, columns): the recalibrated model, fitted to what is not held out. courses: smoothed under these rows.
    learnt: forces (points, 4) of the noise floor's model [N, N, N, N m; world].
    """

    base: Fit
    splits: tuple[Split, ...]
    seconds: float
    rows: Floats
    courses: tuple[Smoothed, ...]
    learnt: Sequence[Floats]

    @property
    def tracks(self) -> tuple[Track, ...]:
        """The tracks of the recalibrated fit."""
        return self.base.tracks

    def windows(self) -> Iterator[tuple[int, Span]]:
        """Number of the track and grid points of each free run."""
        for number, (track, split) in enumerate(zip(self.tracks, self.splits, strict=True)):
            wanted = round(self.seconds / track.timeline.grid.step) + 1
            for held in split.held:
                length = min(wanted, held.points)
                if length >= FREE_RUNS.fewest_points:
                    for first in range(held.first, held.end - length + 1, length):
                        yield number, Span(first, length)


def unseen_parts(base: Fit) -> Unseen:
    """Choose what is held out and how long free runs last, and fit the recalibrated model to the rest."""
    tracks = base.tracks
    coasting = [coasting_time(track.vehicle, row) for track, row in zip(tracks, base.filled, strict=True)]
    seconds = window_length(float(np.median(coasting)), smoothed_tracks(base))
    splits = split_tracks(tracks, seconds)
    rows = fitted_to_the_rest(base, splits)
    courses = tuple(of_each_track(lambda number: tracks[number].filter.smoothed(rows[number]), len(tracks)))
    return Unseen(base, splits, seconds, rows, courses, explained_forces(tracks, courses, rows))


class Model(NamedTuple):
    """A model on its free runs; sequences are by track."""

    rows: Floats  # (tracks, columns)
    sensors: Floats  # (tracks, columns) by which it starts and foretells readings
    starts: Sequence[Floats]  # (points, 8) state at each grid point, given the readings up to it
    pushes: Sequence[Floats]  # (points, 4) force that acts beside it; (0, 4) for none


@dataclass(frozen=True)
class Window:
    """Mean squared errors of a window by channel and model, and its picture."""

    squared: Mapping[str, Mapping[str, float]]
    run: FreeRun


def held_out_free_runs(unseen: Unseen, final: Fit) -> tuple[dict[str, HeldOut], tuple[FreeRun, ...]]:
    """Errors of the three models on the held-out parts, by channel and by stream, and the windows as paths.

    final: the fit with all named effects, to whole recordings; it is fitted anew to what is not held out.
    """
    rulers = {channel: against(channel, unseen.tracks) for channel in CHANNELS}
    shown = {channel: ruler for channel, ruler in rulers.items() if ruler is not None}
    models = _models(unseen, fitted_to_the_rest(final, unseen.splits) if final is not unseen.base else unseen.rows)
    windows = [_window(unseen, models, shown, number, span) for number, span in unseen.windows()]
    if not windows:
        return {}, ()
    table = {channel: _row(channel, ruler, windows, unseen) for channel, ruler in shown.items()}
    rows = {name: models[name].rows for name in MODELS}
    held = [
        [(course.time[span.first], course.time[span.end - 1]) for span in split.held]
        for course, split in zip(unseen.courses, unseen.splits, strict=True)
    ]
    streams = held_out_streams(unseen.tracks, unseen.rows, rows, HeldOutPart(held, unseen.seconds))
    told = {channel: row for channel, row in table.items() if row is not None}
    return {**told, **streams}, tuple(window.run for window in windows)


def _models(unseen: Unseen, augmented: Floats) -> dict[str, Model]:
    """Make the models that run; augmented: rows (tracks, columns) of the one with the effects."""
    tracks, none = unseen.tracks, [NO_PUSH] * len(unseen.tracks)
    own = np.array(
        [
            with_fixed_errors(plain, row, track.timeline)
            for track, plain, row in zip(tracks, unseen.rows, augmented, strict=True)
        ]
    )
    starts = _starts(tracks, unseen.rows)
    own_starts = starts if np.array_equal(own, unseen.rows) else _starts(tracks, own)
    return {
        "nominal": Model(unseen.base.rows, unseen.rows, starts, none),
        "recalibrated": Model(unseen.rows, unseen.rows, starts, none),
        "augmented": Model(augmented, own, own_starts, none),
        FLOOR: Model(unseen.rows, unseen.rows, starts, unseen.learnt),
    }


def _starts(tracks: Sequence[Track], rows: Floats) -> list[Floats]:
    return of_each_track(lambda number: tracks[number].filter.filtered(rows[number]), len(tracks))


def _window(
    unseen: Unseen, models: Mapping[str, Model], shown: Mapping[str, Against], number: int, span: Span
) -> Window:
    """Run all models freely through a window of a track."""
    track, course = unseen.tracks[number], unseen.courses[number]
    squared: dict[str, dict[str, float]] = {channel: {} for channel in shown}
    paths, measured = {}, np.full((span.points, len(SHOWN)), np.nan)
    for name, model in models.items():
        path = _path(track, model, number, span)
        paths[name] = path.mean[span.first : span.end][:, SHOWN]
        for channel, ruler in shown.items():
            errors = (
                errors_of_readings(channel, track, path, model.sensors[number], span)
                if ruler == "readings"
                else errors_of_course(channel, path, course, span)
            )
            squared[channel][name] = errors.mean_square
            if name == "recalibrated":
                _draw(measured, channel, errors, paths[name], course.time[span.first : span.end])
    time = course.time[span.first : span.end]
    return Window(squared, FreeRun(track.name, time, measured, *(paths[name] for name in MODELS)))


def _path(track: Track, model: Model, number: int, span: Span) -> Smoothed:
    """Free run of a model over a window; before and behind it, what its filter had made of the readings."""
    states = model.starts[number].copy()
    push = model.pushes[number][span.first : span.end]
    row, start = model.rows[number], states[span.first, :STATE_SIZE]
    states[span.first : span.end] = track.filter.free_run(row, start, span.first, span.points, push)
    return Smoothed(track.timeline.grid.moments, states, np.zeros_like(states))


def _draw(measured: Floats, channel: str, errors: Errors, path: Floats, time: Floats) -> None:
    """Write what a channel was measured by into `measured` (n, 4): at each grid point the path and its error there."""
    if not len(errors.time):
        return
    point = np.clip(np.rint((errors.time - time[0]) / (time[1] - time[0])), 0, len(time) - 1).astype(int)
    for place, column in enumerate(CHANNELS[channel].columns):
        at = SHOWN.index(column)
        measured[point, at] = path[point, at] + errors.value[:, place]


def _row(channel: str, ruler: Against, windows: Sequence[Window], unseen: Unseen) -> HeldOut | None:
    """Root mean squares of a channel over all windows with bootstrap intervals; None if no window has readings."""
    means = {name: np.array([window.squared[channel][name] for window in windows]) for name in (*MODELS, FLOOR)}
    read = np.isfinite(means["recalibrated"])
    if not read.any():
        return None
    means = {name: mean[read] for name, mean in means.items()}
    # A law that was learnt in vain is none: the floor is never above a model without any.
    plain = (means[name] for name in (FLOOR, "recalibrated", "nominal"))
    means[FLOOR] = min(plain, key=lambda mean: float(mean.mean()))
    draws = drawn(np.random.default_rng(0), int(read.sum()))
    intervals = {name: interval_of_root(values, draws) for name, values in means.items()}
    values = {name: float(np.sqrt(mean.mean())) for name, mean in means.items()}
    seconds = max(float(window.run.time[-1] - window.run.time[0]) for window in windows)
    return HeldOut(**values, unit=CHANNELS[channel].unit, intervals=intervals, seconds=round(seconds, 6), against=ruler)
