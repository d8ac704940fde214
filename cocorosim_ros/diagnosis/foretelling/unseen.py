"""Parts of the recordings that no fit sees, the measure that is made there of the recalibrated model, and free runs.

Every model starts from one state: what the recalibrated model's filter had made of the readings up to that moment,
without later ones and without the named effects, so that what is compared differs by the models alone. Two things make
exceptions, since with them the readings of one state are others: the errors of readings that count (`fixed_errors`),
and water that moves, where a log shows the speed through it or a receiver's places wander, which a filter without the
current takes for the cause of the drift. With errors of readings a model starts from what its own filter made of them,
because the recalibrated one was fitted to readings that err. From there a model takes no readings and no random force,
and is measured against the readings that come. A smoothed course is no measure: it is bent by the model that made it.
Where no reading shows a channel, the recalibrated model's smoothed course stands in, which no named effect has bent;
where readings err, it is bent by them, and nothing stands in.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUNS
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks, smoothed_under
from cocorosim_ros.diagnosis.foretelling.fixed_errors import OF_READINGS, with_fixed_errors
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span, Split, fitted_to_the_rest, split_tracks, whole
from cocorosim_ros.diagnosis.foretelling.horizon import window_length
from cocorosim_ros.diagnosis.foretelling.nameless_force import explained_forces
from cocorosim_ros.diagnosis.foretelling.regimes import regimes_along
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, MOVING_WATER, WANDER, WHITE
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.track_filter import NO_PUSH
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track
from cocorosim_ros.diagnosis.tracks.vehicle_size import coasting_time
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.state.state import STATE_SIZE


@dataclass(frozen=True)
class Unseen:
    """Measure of all models, made from the recalibrated fit alone; sequences are by track.

    rows (tracks, columns): the recalibrated model, fitted to what is not held out. courses: smoothed under these rows.
    starts: states (points, 8) under these rows, at each grid point given the readings up to it. learnt: forces
    (points, 4) of the noise floor's model [N, N, N, N m; world].
    """

    base: Fit
    splits: tuple[Split, ...]
    seconds: float
    rows: Floats
    courses: tuple[Smoothed, ...]
    starts: Sequence[Floats]
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


def seconds_of_free_runs(fit: Fit) -> float:
    """Length [s] of the free runs of a vehicle that moves as a fit says."""
    return _seconds(fit, smoothed_tracks(fit))


def _seconds(fit: Fit, courses: Sequence[Smoothed]) -> float:
    coasting = [coasting_time(track.vehicle, row) for track, row in zip(fit.tracks, fit.filled, strict=True)]
    return window_length(float(np.median(coasting)), courses)


def unseen_parts(base: Fit, seconds: float | None = None, among: Collection[int] | None = None) -> Unseen:
    """Choose what is held out and how long free runs last, and fit the recalibrated model to the rest.

    seconds: length of the free runs [s]; None: that of a vehicle that moves as the recalibrated model does. among:
    numbers of the tracks of which parts are held out; None: all.
    """
    tracks, seen = base.tracks, smoothed_tracks(base)
    seconds = _seconds(base, seen) if seconds is None else seconds
    regimes = [regimes_along(track, course) for track, course in zip(tracks, seen, strict=True)]
    splits = split_tracks(tracks, seconds, range(len(tracks)) if among is None else among, regimes)
    rows = fitted_to_the_rest(base, splits)
    courses = smoothed_under(tracks, rows)
    return Unseen(
        base, splits, seconds, rows, courses, starts_of(tracks, rows), explained_forces(tracks, courses, rows)
    )


def whole_tracks(fit: Fit) -> Unseen:
    """Take whole tracks, but for their beginnings, as what free runs go through by the very numbers of a fit.

    A fit whose numbers stand for something else foretells not even what it has seen. There is no noise floor's model.
    """
    tracks, rows = fit.tracks, fit.filled
    splits = tuple(whole(track.timeline.grid.points) for track in tracks)
    return Unseen(
        fit, splits, seconds_of_free_runs(fit), rows, smoothed_under(tracks, rows), starts_of(tracks, rows),
        [NO_PUSH] * len(tracks),
    )  # fmt: skip


class Model(NamedTuple):
    """A model on its free runs; sequences are by track."""

    rows: Floats  # (tracks, columns)
    sensors: Floats  # (tracks, columns) by which it starts and foretells readings
    starts: Sequence[Floats]  # (points, 8) state at each grid point, given the readings up to it
    pushes: Sequence[Floats]  # (points, 4) force that acts beside it; (0, 4) for none


def with_errors_of(unseen: Unseen, rows: Floats) -> Floats:
    """Rows (tracks, columns) of the recalibrated model, with those errors of readings in `rows` that count."""
    return np.array(
        [
            with_fixed_errors(plain, row, track.timeline)
            for track, plain, row in zip(unseen.tracks, unseen.rows, rows, strict=True)
        ]
    )


def rows_at_start(unseen: Unseen, rows: Floats, sensors: Floats) -> Floats:
    """Rows (tracks, columns) by which a model reads what comes before its free runs.

    rows (tracks, columns): the model. sensors (tracks, columns): the recalibrated one, with those errors of readings
    and stamps of the model that count. Where some do, the model reads by its own numbers: those of the recalibrated one
    were fitted to readings that err.
    """
    started = sensors.copy()
    for number, track in enumerate(unseen.tracks):
        if not np.array_equal(sensors[number], unseen.rows[number]):
            started[number] = rows[number]
            started[number, OF_READINGS] = sensors[number, OF_READINGS]
        if _reads_the_water(track) or unseen.rows[number, COLUMN[WANDER]] > WHITE:
            started[number, MOVING_WATER] = rows[number, MOVING_WATER]
    return started


def _reads_the_water(track: Track) -> bool:
    return any(track.timeline.sees(name) for name, kind in KINDS.items() if kind.of_water)


def starts_under(unseen: Unseen, started: Floats) -> list[Floats]:
    """States (points, 8) by track, at each grid point given the readings up to it, under rows of `rows_at_start`."""
    return list(unseen.starts) if np.array_equal(started, unseen.rows) else starts_of(unseen.tracks, started)


def starts_of(tracks: Sequence[Track], rows: Floats) -> list[Floats]:
    """States (points, 8) by track, at each grid point given the readings up to it, under rows (tracks, columns)."""
    return of_each_track(lambda number: tracks[number].filter.filtered(rows[number]), len(tracks))


def path_of(track: Track, model: Model, number: int, span: Span) -> Smoothed:
    """Free run of a model over a window; before and behind it, what its filter had made of the readings."""
    states = model.starts[number].copy()
    push = model.pushes[number][span.first : span.end]
    row, start = model.rows[number], states[span.first, :STATE_SIZE]
    states[span.first : span.end] = track.filter.free_run(row, start, span.first, span.points, push)
    return Smoothed(track.timeline.grid.moments, states, np.zeros_like(states))
