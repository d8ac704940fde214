"""Free runs through held-out parts of the recordings, by models fitted to the other parts alone, against readings.

The noise floor is the error, by the same measure, of a model that names nothing: the recalibrated one with a learnt
force (`nameless_force`). It holds the error of the readings, that of the start and what random force does; an augmented
model has no part in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.findings import Against, FreeRun, HeldOut
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.foretelling.bootstrap import drawn, interval_of_root
from cocorosim_ros.diagnosis.foretelling.gains import Gain, gain
from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span, fitted_to_the_rest
from cocorosim_ros.diagnosis.foretelling.held_out_streams import HeldOutPart, held_out_streams
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS, Errors, against, errors_of_course, errors_of_readings
from cocorosim_ros.diagnosis.foretelling.unseen import (
    Model,
    Unseen,
    path_of,
    rows_at_start,
    starts_under,
    with_errors_of,
)
from cocorosim_ros.diagnosis.tracks.body_velocity import body_velocity
from cocorosim_ros.diagnosis.tracks.track_filter import NO_PUSH
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import YAW, X, Y, Z

MODELS = ("nominal", "recalibrated", "augmented")
FLOOR = "noise_floor"
SHOWN = (X, Y, Z, YAW)  # columns of the state that a picture has


@dataclass(frozen=True)
class Window:
    """Mean squared errors of a window by channel and model, and its picture."""

    squared: Mapping[str, Mapping[str, float]]
    run: FreeRun


class HeldOutFreeRuns(NamedTuple):
    """Errors by channel and by stream, the windows as paths, and what the augmented model gains over the recalibrated.

    gain: by the channels that readings show; None without windows.
    """

    table: dict[str, HeldOut]
    runs: tuple[FreeRun, ...]
    gain: Gain | None


def held_out_free_runs(unseen: Unseen, final: Fit) -> HeldOutFreeRuns:
    """Errors of the three models on the held-out parts, with the windows as paths.

    final: the fit with all named effects, to whole recordings; it is fitted anew to what is not held out.
    """
    rulers = {channel: against(channel, unseen.tracks) for channel in CHANNELS}
    shown = {channel: ruler for channel, ruler in rulers.items() if ruler is not None}
    models = _models(unseen, fitted_to_the_rest(final, unseen.splits) if final is not unseen.base else unseen.rows)
    if not np.array_equal(models["augmented"].sensors, unseen.rows):  # which bends the course that would stand in
        shown = {channel: ruler for channel, ruler in shown.items() if ruler == "readings"}
    windows = [_window(unseen, models, shown, number, span) for number, span in unseen.windows()]
    if not windows:
        return HeldOutFreeRuns({}, (), None)
    table = {channel: _row(channel, ruler, windows, unseen) for channel, ruler in shown.items()}
    rows = {name: models[name].rows for name in MODELS}
    held = [
        [(course.time[span.first], course.time[span.end - 1]) for span in split.held]
        for course, split in zip(unseen.courses, unseen.splits, strict=True)
    ]
    streams = held_out_streams(unseen.tracks, unseen.rows, rows, HeldOutPart(held, unseen.seconds))
    told = {channel: row for channel, row in table.items() if row is not None}
    return HeldOutFreeRuns({**told, **streams}, tuple(window.run for window in windows), _gain(windows, told))


def _gain(windows: Sequence[Window], told: Mapping[str, HeldOut]) -> Gain:
    """Gain of the augmented model over the recalibrated one by the channels of a table that readings show."""
    channels = [channel for channel, row in told.items() if row.against == "readings"]

    def errors(name: str) -> Floats:
        found = [[window.squared[channel][name] for channel in channels] for window in windows]
        return np.array(found, dtype=np.float64).reshape(len(windows), len(channels))

    floor = np.array([told[channel].noise_floor ** 2 for channel in channels])
    return gain(errors("recalibrated"), errors("augmented"), floor)


def _models(unseen: Unseen, augmented: Floats) -> dict[str, Model]:
    """Make the models that run; augmented: rows (tracks, columns) of the one with the effects."""
    none = [NO_PUSH] * len(unseen.tracks)
    starts, sensors = unseen.starts, with_errors_of(unseen, augmented)
    return {
        "nominal": Model(unseen.base.rows, unseen.rows, starts, none),
        "recalibrated": Model(unseen.rows, unseen.rows, starts, none),
        "augmented": Model(augmented, sensors, starts_under(unseen, rows_at_start(unseen, augmented, sensors)), none),
        FLOOR: Model(unseen.rows, unseen.rows, starts, unseen.learnt),
    }


def _window(
    unseen: Unseen, models: Mapping[str, Model], shown: Mapping[str, Against], number: int, span: Span
) -> Window:
    """Run all models freely through a window of a track."""
    track, course = unseen.tracks[number], unseen.courses[number]
    time = course.time[span.first : span.end]
    squared: dict[str, dict[str, float]] = {channel: {} for channel in shown}
    paths, velocity, measured = {}, None, np.full((span.points, len(SHOWN)), np.nan)
    for name, model in models.items():
        path = path_of(track, model, number, span)
        states = path.mean[span.first : span.end]
        paths[name] = states[:, SHOWN]
        if name == "augmented":
            velocity = body_velocity(track, time, states, model.rows[number])
        for channel, ruler in shown.items():
            errors = (
                errors_of_readings(channel, track, path, model.sensors[number], span)
                if ruler == "readings"
                else errors_of_course(channel, path, course, span)
            )
            squared[channel][name] = errors.mean_square
            if name == "recalibrated":
                _draw(measured, channel, errors, paths[name], time)
    run = FreeRun(track.name, time, measured, *(paths[name] for name in MODELS))  # type: ignore[arg-type]
    return Window(squared, replace(run, clock=track.log.clock, velocity=velocity))


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
